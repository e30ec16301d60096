import { readFile, stat } from 'node:fs/promises'
import { join } from 'node:path'
import { Command } from 'commander'
import { FurrowError } from 'furrow'
import { COMPRESSIONS, type Compression, type NamedArray } from '../array/image-array.ts'
import { readArray, writeArray } from '../array/ktx2.ts'
import { readLayers } from '../array/read-layers.ts'
import { firstLine, writeAll } from '../images.ts'
import { readChoice } from '../numbers.ts'
import { withBar } from '../progress.ts'
import { checkWritable } from '../render/write-png.ts'
import { encodePixels } from '../wrinkles/map-images.ts'

const WHO = 'furrow array'

interface Options {
  output?: string
  extract?: string
  srgb?: boolean
  compress?: string
  mipmaps: boolean
  json?: boolean
}

/** `furrow array`: images to one KTX 2 texture array, and back. */
export const arrayCommand = new Command('array')
  .description('put images into one texture array (KTX 2), or take them out again')
  .argument('<files...>', 'images of one size, in the order of their layers; or one .ktx2 with --extract')
  .option('-o, --output <file>', 'the array (.ktx2)')
  .option('--extract <folder>', 'write the layers of an array as PNG files, named as they were')
  .option('--srgb', 'the images are colours; normal maps, areas and other numbers are not')
  .option(
    '--compress <kind>',
    'none, zstd (default; exact), uastc or etc1s (both stay compressed on the GPU)',
  )
  .option('--no-mipmaps', 'with uastc or etc1s: only the full size')
  .option('--json', 'print what was made as JSON')
  .addHelpText(
    'after',
    `
Examples:
  $ furrow array areas/foreheadLeft.png areas/foreheadRight.png -o areas.ktx2
  $ furrow array layers/*.png -o layers.ktx2 --compress uastc
  $ furrow array areas.ktx2 --extract areas`,
  )
  .action(makeArray)

async function makeArray(files: string[], options: Options): Promise<void> {
  const { output, extract } = options
  if ((output === undefined) === (extract === undefined)) {
    throw new FurrowError({
      who: WHO,
      what: 'not clear what to do',
      limit: 'either IMAGES -o ARRAY.ktx2, or ARRAY.ktx2 --extract FOLDER',
      remedy: 'give exactly one of -o and --extract',
    })
  }
  const made = output === undefined ? await unpack(files, extract!) : await pack(files, output, options)
  const { width, height, channels, srgb, names, file, bytes, gpuBytes, compression } = made
  const format = `${channels === 1 ? 'gray' : 'RGBA'}${srgb ? ' sRGB' : ''}, ${compression}`
  const onGpu = gpuBytes === undefined ? '' : `, ${kilo(gpuBytes)} on the GPU`
  const text = options.json
    ? JSON.stringify({ file, width, height, layers: names, channels, srgb, compression, bytes, gpuBytes })
    : `${file}: ${names.length} ${names.length === 1 ? 'layer' : 'layers'} of ${width} x ${height}, ${format}, ${kilo(bytes)} in the file${onGpu}`
  process.stdout.write(`${text}\n`)
}

type Made = NamedArray & { file: string; compression: Compression; bytes: number; gpuBytes?: number }

async function pack(files: string[], output: string, options: Options): Promise<Made> {
  const compression = readChoice(WHO, '--compress', options.compress ?? 'zstd', COMPRESSIONS)
  await checkWritable(output, WHO, '.ktx2')
  const array = await withBar('array', (progress) => readLayers(files, options.srgb ?? false, progress))
  const bytes = await writeArray(array, compression, options.mipmaps)
  await writeAll([{ path: output, bytes }], WHO)
  return {
    ...array,
    file: output,
    compression,
    bytes: bytes.length,
    gpuBytes: sizeOnGpu(array, compression, options.mipmaps),
  }
}

async function unpack(files: string[], folder: string): Promise<Made> {
  const [path, ...more] = files
  if (more.length > 0) {
    throw new FurrowError({
      who: WHO,
      what: 'too many files to extract from',
      value: files.length,
      limit: '1 array',
      remedy: 'extract one array after the other',
    })
  }
  const found = await stat(folder).catch(() => undefined)
  if (found && !found.isDirectory()) {
    throw new FurrowError({
      who: WHO,
      what: `${folder} is not a folder`,
      remedy: 'name a folder for the layers',
    })
  }
  const { bytes, array } = await readFileOf(path)
  const outputs = await Promise.all(
    array.layers.map(async (layer, i) => ({
      path: join(folder, `${array.names[i]}.png`),
      bytes: await encodePixels({ ...array, data: layer }),
    })),
  )
  for (const output of outputs) await checkWritable(output.path, WHO)
  await writeAll(outputs, WHO)
  return { ...array, file: folder, bytes: bytes.length }
}

async function readFileOf(path: string) {
  try {
    const bytes = await readFile(path)
    return { bytes, array: await readArray(bytes) }
  } catch (error) {
    throw new FurrowError({
      who: WHO,
      what: `cannot read the array ${path} (${firstLine(error)})`,
      limit: 'KTX 2: 2D, R8 or RGBA8 (plain or Zstandard), UASTC, ETC1S',
      remedy: 'check the path and the file',
    })
  }
}

/**
 * Bytes once uploaded. UASTC becomes ASTC 4x4 or BC7, 16 bytes per block of 4 x 4 texels; ETC1S becomes ETC1 or BC1,
 * 8 bytes, where the GPU has them, otherwise 16.
 */
function sizeOnGpu(array: NamedArray, compression: Compression, mipmaps: boolean): number {
  const { width, height, channels, layers } = array
  if (compression === 'none' || compression === 'zstd') return width * height * channels * layers.length
  let blocks = 0
  for (let level = 0; level === 0 || (mipmaps && Math.max(width, height) >> level > 0); level++) {
    const [w, h] = [Math.max(width >> level, 1), Math.max(height >> level, 1)]
    blocks += Math.ceil(w / 4) * Math.ceil(h / 4)
  }
  return blocks * (compression === 'uastc' ? 16 : 8) * layers.length
}

const kilo = (bytes: number) => `${(bytes / 1024).toFixed(1)} KiB`
