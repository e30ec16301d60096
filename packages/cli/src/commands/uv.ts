import { MAX_IMAGE_SIDE } from 'furrow/internal'
import { documentOf, findSkin } from 'furrow-files'
import { encodePng, type ReadOptions, readGlbFile } from 'furrow-files/node'
import { createCommand } from '../command.ts'
import { writeAll } from '../files.ts'
import { allowOutsideOption, numberParser } from '../options.ts'
import { checkOutputs } from '../outputs.ts'
import { print } from '../print.ts'
import { drawSkinLayout } from '../uv/draw-layout.ts'

const WHO = 'furrow uv'

const DEFAULT_SIZE = 2048

interface Options extends ReadOptions {
  output: string
  size: number
  mesh?: string
  json?: boolean
}

/** `furrow uv`: a template to paint over. */
export const uvCommand = createCommand('uv')
  .description("draw the UV layout of a face's skin, as a template to paint areas and layers over")
  .argument('<face>', 'a face (.glb, .vrm, .gltf)')
  .requiredOption('-o, --output <file>', 'the template (.png), transparent where there is no skin')
  .option(
    '--size <texels>',
    'its side, 64 to 8192',
    numberParser({ min: 64, max: MAX_IMAGE_SIDE, unit: 'texels', integer: true }),
    DEFAULT_SIZE,
  )
  .option('--mesh <name>', 'its mesh (default: the one whose skin brows, lids and mouth move)')
  .addOption(allowOutsideOption())
  .option('--json', 'print the result as JSON')
  .addHelpText(
    'after',
    `
Thick lines are the borders of UV islands: wrinkles that cross one continue at another.

Examples:
  $ furrow uv avatar.glb -o uv.png
  $ furrow uv avatar.vrm -o uv.png --size 4096 --mesh Face`,
  )
  .action(drawUv)

async function drawUv(path: string, { output, size, mesh, json, ...options }: Options): Promise<void> {
  await checkOutputs([output], WHO, { inputs: [path] })
  const glb = await readGlbFile(path, WHO, options)
  const found = findSkin(await documentOf(glb, path, WHO), path, WHO, mesh)
  const data = await drawSkinLayout(glb, found, size, WHO)
  await writeAll(
    [{ path: output, bytes: await encodePng({ width: size, height: size, channels: 4, data }) }],
    WHO,
  )
  const { meshName, materialName, reason } = found
  const line = `${output}: ${size} x ${size}, mesh "${meshName}", material "${materialName}" (${reason})`
  print(
    json ? JSON.stringify({ file: output, size, mesh: meshName, material: materialName, reason }) : line,
    output,
  )
}
