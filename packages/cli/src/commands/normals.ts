import { Option } from 'commander'
import { FurrowError } from 'furrow'
import { BUMP_DEFAULTS, type BumpOptions, bumpToNormal, type NormalMap } from 'furrow/author'
import { encodeNormalMap, type HeightImage, readHeightImage } from 'furrow-files/node'
import { createCommand } from '../command.ts'
import { writeAll } from '../files.ts'
import { forceOption, numberParser } from '../options.ts'
import { checkOutputs } from '../outputs.ts'
import { print, warn } from '../print.ts'
import { withBar } from '../progress.ts'

const WHO = 'furrow normals'

interface Options extends Required<Pick<BumpOptions, 'green' | 'edges'>> {
  output: string
  /** Height of white above black, millimetres. */
  depth?: number
  /** Width of the image on the surface, millimetres. */
  width?: number
  /** Height of white above black, texels. */
  strength?: number
  bits: '8' | '16'
  force?: boolean
  json?: boolean
}

const millimetres = numberParser({ min: 1e-6, max: 1e6, unit: 'mm' })

export const normalsCommand = createCommand('normals')
  .description('convert a height map to a normal map')
  .argument('<height>', 'height map, white = high (8- or 16-bit gray PNG or TIFF)')
  .requiredOption('-o, --output <file>', 'normal map (.png)')
  .option('--depth <mm>', 'height of white above black', millimetres)
  .option('--width <mm>', 'width of the image', millimetres)
  .addOption(
    new Option('--strength <texels>', 'height of white above black, in texels')
      .argParser(numberParser({ min: -1e5, max: 1e5, unit: 'texels' }))
      .conflicts(['depth', 'width']),
  )
  .addOption(
    new Option('--green <direction>', 'green channel: up for glTF, down for Direct3D')
      .choices(['up', 'down'])
      .default(BUMP_DEFAULTS.green),
  )
  .addOption(
    new Option('--edges <kind>', 'edge mode; wrap for tiling images')
      .choices(['wrap', 'clamp'])
      .default(BUMP_DEFAULTS.edges),
  )
  .addOption(
    new Option('--bits <bits>', 'bits per channel').choices(['8', '16']).default(String(BUMP_DEFAULTS.bits)),
  )
  .addOption(forceOption())
  .option('--json', 'print the result as JSON')
  .addHelpText(
    'after',
    `
Give either --strength, or both --depth and --width.

Examples:
  $ furrow normals height.png -o normal.png --depth 2.5 --width 180
  $ furrow normals tile.tif -o normal.png --strength 12 --edges wrap --bits 16`,
  )
  .action(makeNormals)

async function makeNormals(path: string, options: Options): Promise<void> {
  const { output, green, edges, json, force = false } = options
  const bits = options.bits === '8' ? 8 : 16
  const heightRange = heightRangeOf(options)
  await checkOutputs([output], WHO, { inputs: [path], force })
  const image = await readHeightImage(path, WHO)
  const { width, height } = image
  const bump = { width, height, data: inTexels(image, heightRange(width)) }
  const map = withBar('normals', (progress) => bumpToNormal(bump, { green, edges, bits }, progress))
  await writeAll([{ path: output, bytes: await encodeNormalMap(map) }], WHO, { named: [output], force })
  const made = { file: output, width, height, bits, green, edges, steepest: steepestSlope(map, bits) }
  const line = json
    ? JSON.stringify(made)
    : `${output}: ${width} x ${height}, ${bits} bits, green ${green}, steepest slope ${made.steepest} degrees`
  print(line, output)
  if (image.bits === 8) {
    warn(`${WHO}: ${path} has only 8 bits, so gentle slopes show steps; use a 16-bit height map`)
  }
}

/** Returns a function that converts the width of the image in texels to the height of white above black in texels. */
function heightRangeOf({ depth, width, strength }: Options): (texels: number) => number {
  if (strength !== undefined) return () => strength
  if (depth !== undefined && width !== undefined) return (texels) => (depth * texels) / width
  throw new FurrowError({
    code: 'usage',
    who: WHO,
    problem: 'the depth of the height map is missing',
    limit: '--depth MM with --width MM, or --strength TEXELS',
    remedy: 'add e.g. --depth 2.5 --width 180',
  })
}

/** Converts the values of a height map to heights in texels. `range` is the height of white above black. */
function inTexels({ data, bits }: HeightImage, range: number): Float32Array {
  const scale = range / (2 ** bits - 1)
  const texels = new Float32Array(data.length)
  for (let i = 0; i < data.length; i++) texels[i] = data[i] * scale
  return texels
}

/** Returns the steepest slope of a normal map: the largest angle between a normal and +z, in degrees. */
function steepestSlope({ data }: NormalMap, bits: 8 | 16): number {
  let smallestZ = 1
  for (let i = 2; i < data.length; i += 3)
    smallestZ = Math.min(smallestZ, (2 * data[i]) / (2 ** bits - 1) - 1)
  return Math.round(1800 * (Math.acos(smallestZ) / Math.PI)) / 10
}
