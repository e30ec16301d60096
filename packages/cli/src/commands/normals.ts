import { Command } from 'commander'
import { FurrowError } from 'furrow'
import { type NormalMap, RELIEF_DEFAULTS, reliefToNormal } from 'furrow/author'
import { type HeightImage, readHeightImage } from '../height-image.ts'
import { writeAll } from '../images.ts'
import { encodeNormalMap } from '../normal-map.ts'
import { readChoice, readNumber } from '../numbers.ts'
import { withBar } from '../progress.ts'
import { checkWritable } from '../render/write-png.ts'

const WHO = 'furrow normals'

interface Options {
  output: string
  depth?: string
  width?: string
  strength?: string
  green: string
  edges: string
  bits: string
  json?: boolean
}

/** `furrow normals`: a normal map from a height map. */
export const normalsCommand = new Command('normals')
  .description('make a normal map from a height map')
  .argument('<height>', 'gray image of heights, white = high: PNG or TIFF, 8 or 16 bits')
  .requiredOption('-o, --output <file>', 'the normal map (.png)')
  .option('--depth <mm>', 'height of white above black in millimetres; needs --width')
  .option('--width <mm>', 'width of the whole picture in millimetres; needs --depth')
  .option('--strength <texels>', 'instead of both: height of white above black in texels')
  .option('--green <way>', 'up (glTF, OpenGL) or down (Direct3D)', RELIEF_DEFAULTS.green)
  .option('--edges <kind>', 'wrap (the picture tiles) or clamp (it ends)', RELIEF_DEFAULTS.edges)
  .option('--bits <bits>', '8 or 16 per channel', String(RELIEF_DEFAULTS.bits))
  .option('--json', 'print what was made as JSON')
  .addHelpText(
    'after',
    `
Examples:
  $ furrow normals height.png -o normal.png --depth 2.5 --width 180
  $ furrow normals tile.tif -o normal.png --strength 12 --edges wrap --green down --bits 16`,
  )
  .action(makeNormals)

async function makeNormals(path: string, options: Options): Promise<void> {
  const { output, json } = options
  const green = readChoice(WHO, '--green', options.green, ['up', 'down'])
  const edges = readChoice(WHO, '--edges', options.edges, ['wrap', 'clamp'])
  const bits = readChoice(WHO, '--bits', options.bits, ['8', '16']) === '8' ? 8 : 16
  const rise = readRise(options)
  await checkWritable(output, WHO)
  const image = await readHeightImage(path, WHO)
  const { width, height } = image
  const relief = { width, height, data: inTexels(image, rise(width)) }
  const map = withBar('normals', (progress) => reliefToNormal(relief, { green, edges, bits }, progress))
  await writeAll([{ path: output, bytes: await encodeNormalMap(map) }], WHO)
  const made = { file: output, width, height, bits, green, edges, steepest: steepest(map, bits) }
  const text = json
    ? JSON.stringify(made)
    : `${output}: ${width} x ${height}, ${bits} bits, green ${green}, steepest slope ${made.steepest} degrees`
  process.stdout.write(`${text}\n`)
  if (image.bits === 8) {
    console.error(
      `${WHO}: ${path} has 8 bits, so gentle slopes come out as steps; a 16-bit height map is smooth`,
    )
  }
}

/** How many texels white lies above black, once the width of the picture is known. */
function readRise({ depth, width, strength }: Options): (texels: number) => number {
  const measure = { low: 1e-6, high: 1e6, unit: 'mm' }
  if (strength !== undefined && depth === undefined && width === undefined) {
    const rise = readNumber(WHO, '--strength', strength, {
      low: -1e5,
      high: 1e5,
      unit: 'texels',
      example: 10,
    })
    return () => rise
  }
  if (strength === undefined && depth !== undefined && width !== undefined) {
    const mm = readNumber(WHO, '--depth', depth, { ...measure, example: 2.5 })
    const wide = readNumber(WHO, '--width', width, { ...measure, example: 180 })
    return (texels) => (mm * texels) / wide
  }
  throw new FurrowError({
    who: WHO,
    what: 'the strength is not clear',
    limit: 'either --depth MM with --width MM, or --strength TEXELS alone',
    remedy: 'write e.g. --depth 2.5 --width 180',
  })
}

function inTexels({ data, bits }: HeightImage, rise: number): Float32Array {
  const scale = rise / (2 ** bits - 1)
  const texels = new Float32Array(data.length)
  for (let i = 0; i < data.length; i++) texels[i] = data[i] * scale
  return texels
}

/** In degrees, as read from the map. */
function steepest({ data }: NormalMap, bits: 8 | 16): number {
  let lowest = 1
  for (let i = 2; i < data.length; i += 3) lowest = Math.min(lowest, (2 * data[i]) / (2 ** bits - 1) - 1)
  return Math.round(1800 * (Math.acos(lowest) / Math.PI)) / 10
}
