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

export const uvCommand = createCommand('uv')
  .description('draw the UV layout as a painting template')
  .argument('<face>', 'face (.glb, .vrm, .gltf)')
  .requiredOption('-o, --output <file>', 'template (.png) with a transparent background')
  .option(
    '--size <texels>',
    `size of the image, 64 to ${MAX_IMAGE_SIDE}`,
    numberParser({ min: 64, max: MAX_IMAGE_SIDE, unit: 'texels', integer: true }),
    DEFAULT_SIZE,
  )
  .option('--mesh <name>', 'mesh to draw (default: detected)')
  .addOption(allowOutsideOption())
  .option('--json', 'print the result as JSON')
  .addHelpText(
    'after',
    `
Thick lines are the borders of UV islands.

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
