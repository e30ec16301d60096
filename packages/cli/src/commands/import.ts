import { InvalidArgumentError, Option } from 'commander'
import { MAX_IMAGE_SIDE } from 'furrow/internal'
import {
  encodeGlb,
  kilobytes,
  PACK_DEFAULTS,
  parseWrinkledFile,
  stripWrinkles,
  unpackWrinkles,
} from 'furrow-files'
import {
  detectSource,
  FACE_EXTENSIONS,
  IMPORT_SOURCES,
  type ImportResult,
  type ImportSource,
  importWrinkles,
  openSourceFiles,
  POWER_RANGE,
  REGIONS,
  readGlbFile,
} from 'furrow-files/node'
import { createCommand } from '../command.ts'
import { faceFiles } from '../face-outputs.ts'
import { writeAll, writeFolder } from '../files.ts'
import { allowOutsideOption, assignmentParser, forceOption, numberParser } from '../options.ts'
import { checkNewFolder, checkOutputs } from '../outputs.ts'
import { print, warn } from '../print.ts'
import { withBar } from '../progress.ts'

const WHO = 'furrow import'

interface Options {
  output: string
  face: string
  from?: ImportSource
  mesh?: string
  material?: string
  size?: number
  green?: 'up' | 'down'
  power?: Record<string, number>
  ktx2?: boolean
  allowOutside?: boolean
  force?: boolean
  json?: boolean
}

const assignPower = assignmentParser(POWER_RANGE)

/** Parses `REGION=EXPONENT`. */
function parsePower(text: string, collected?: Record<string, number>): Record<string, number> {
  const powers = assignPower(text, collected)
  const unknown = Object.keys(powers).find(
    (name) => name !== 'all' && !REGIONS.some((region) => region === name),
  )
  if (unknown === undefined) return powers
  throw new InvalidArgumentError(
    `It must be REGION=EXPONENT, with one of the regions all, ${REGIONS.join(', ')}.`,
  )
}

export const importCommand = createCommand('import')
  .description('convert the wrinkle maps of another program')
  .argument('<source>', 'folder of the export, or its .json file')
  .requiredOption('--face <file>', 'the face, as glTF (.glb, .vrm, .gltf)')
  .requiredOption('-o, --output <path>', 'face with wrinkles (.glb, .vrm, .gltf), or a new folder of maps')
  .addOption(new Option('--from <program>', 'kind of the export (default: detected)').choices(IMPORT_SOURCES))
  .option('--mesh <name>', 'target mesh (default: detected)')
  .option('--material <name>', 'target material (default: detected)')
  .option(
    '--size <texels>',
    `width of the maps, 64 to ${MAX_IMAGE_SIDE} (default: up to 1024, so that they fit into 5 MB)`,
    numberParser({ min: 64, max: MAX_IMAGE_SIDE, unit: 'texels', integer: true }),
  )
  .addOption(
    new Option('--green <direction>', 'green of the source: up for OpenGL, down for Direct3D').choices([
      'up',
      'down',
    ]),
  )
  .option(
    '--power <region=exponent...>',
    "power curve of Character Creator's regions, or all=EXPONENT",
    parsePower,
  )
  .option('--ktx2', 'write maps and areas as KTX 2 (UASTC)')
  .addOption(allowOutsideOption())
  .addOption(forceOption())
  .option('--json', 'print the result as JSON')
  .addHelpText(
    'after',
    `
Reads exports of Character Creator and MetaHuman, and expression maps:
neutral.png and one normal map per expression.
The command lists what Furrow's format cannot store, and what it did not read.

Examples:
  $ furrow import scans --face avatar.glb -o wrinkled.glb
  $ furrow import scans --face avatar.glb -o my-face --green down
  $ furrow import Kevin --face kevin.glb -o wrinkled.glb --power all=1.5`,
  )
  .action(importMaps)

async function importMaps(path: string, options: Options): Promise<void> {
  const { output, face, force = false } = options
  const isFace = FACE_EXTENSIONS.some((extension) => output.toLowerCase().endsWith(extension))
  const rules = { named: [output], force }
  if (isFace) await checkOutputs([output], WHO, { extensions: FACE_EXTENSIONS, inputs: [face], force })
  else await checkNewFolder(output, WHO)
  const files = await openSourceFiles(path, WHO, options)
  const glb = await readGlbFile(face, WHO, options)
  const { from = await detectSource(files, WHO), ktx2 = PACK_DEFAULTS.ktx2, power: powers } = options
  const result = await withBar('import', (progress) =>
    importWrinkles(from, files, glb, face, { ...options, ktx2, powers }, WHO, progress),
  )
  if (isFace) await writeAll(await faceFiles(result.glb, output, WHO, rules), WHO, rules)
  else await writeMaps(result, output)
  for (const warning of result.warnings) warn(warning)
  print(options.json ? JSON.stringify(summaryOf(result, output)) : describe(result, output), output)
}

/** Writes the folder of maps that `furrow pack` reads. */
async function writeMaps({ glb, target }: ImportResult, folder: string): Promise<void> {
  const file = parseWrinkledFile(glb, target.material, WHO)
  const { files } = await withBar('unpack', (progress) => unpackWrinkles(file, false, WHO, progress))
  stripWrinkles(glb, target.material, WHO)
  await writeFolder(folder, [...files, { path: 'face.glb', bytes: encodeGlb(glb) }], WHO)
}

function summaryOf({ source, wrinkles, size, bytes, lost, unread }: ImportResult, path: string) {
  const { layers, areas, drivers } = wrinkles
  return {
    path,
    source,
    layers: layers.map(({ name }) => name),
    areas: areas.map(({ name }) => name),
    drivers: drivers.length,
    size,
    bytes,
    lost,
    unread,
  }
}

function describe(result: ImportResult, path: string): string[] {
  const { source, wrinkles, size, bytes, lost, unread, hasNewNormalMap } = result
  const { layers, areas, drivers } = wrinkles
  const counts = `layers: ${layers.length}, areas: ${areas.length}, drivers: ${drivers.length}`
  const lines = [`${path}: ${source}; ${counts}; maps ${size} x ${size}, ${kilobytes(bytes)}`]
  if (hasNewNormalMap) lines.push('the face has no normal map, so it got the neutral one')
  return [...lines, ...lost.map((text) => `lost: ${text}`), ...unread.map((text) => `not read: ${text}`)]
}
