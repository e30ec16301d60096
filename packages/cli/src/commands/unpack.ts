import { encodeGlb, stripWrinkles, unpackWrinkles } from 'furrow-files'
import { readWrinkledFile } from 'furrow-files/node'
import { createCommand } from '../command.ts'
import { writeFolder } from '../files.ts'
import { allowOutsideOption } from '../options.ts'
import { checkNewFolder } from '../outputs.ts'
import { print, warn } from '../print.ts'
import { withBar } from '../progress.ts'

const WHO = 'furrow unpack'

interface Options {
  output: string
  material?: string
  whiteIsVisible?: boolean
  allowOutside?: boolean
  json?: boolean
}

export const unpackCommand = createCommand('unpack')
  .description('extract wrinkles into a folder of images')
  .argument('<face>', 'face with wrinkles (.glb, .vrm, .gltf)')
  .requiredOption('-o, --output <folder>', 'folder to write, new or empty')
  .option('--material <name>', 'material with wrinkles (default: the only one)')
  .option('--white-is-visible', 'white means visible in areas (default: black)')
  .addOption(allowOutsideOption())
  .option('--json', 'print the result as JSON')
  .addHelpText(
    'after',
    `
Writes face.glb without wrinkles, wrinkles.json, layers/, areas/, and
strokes.json if the face has strokes. furrow pack reads this folder.

Example:
  $ furrow unpack wrinkled.glb -o my-face`,
  )
  .action(unpack)

async function unpack(path: string, options: Options): Promise<void> {
  const { output, whiteIsVisible = false, json } = options
  await checkNewFolder(output, WHO)
  const file = await readWrinkledFile(path, WHO, options)
  const { files: outputs, warnings } = await withBar('unpack', (progress) =>
    unpackWrinkles(file, whiteIsVisible, WHO, progress),
  )
  const remaining = stripWrinkles(file.glb, file.material, WHO)
  outputs.push({ path: 'face.glb', bytes: encodeGlb(file.glb) })
  await writeFolder(output, outputs, WHO)
  if (remaining > 0) {
    const reason = 'removing them would renumber the textures after them'
    warnings.push(`${WHO}: ${remaining} unused textures stay in face.glb; ${reason}`)
  }
  for (const warning of warnings) warn(warning)
  const files = outputs.map((item) => item.path).sort()
  const { layers, areas } = file.maps
  const line = json
    ? JSON.stringify({ folder: output, files })
    : `${output}: ${files.length} files; layers: ${layers.length}, areas: ${areas.length}`
  print(line)
}
