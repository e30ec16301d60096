import { join } from 'node:path'
import { Option } from 'commander'
import { FurrowError } from 'furrow'
import { fileNamesOf } from 'furrow/internal'
import {
  COMPRESSIONS,
  type Compression,
  cannotRead,
  type NamedArray,
  readArray,
  writeArray,
} from 'furrow-files'
import { encodePngWithoutOpaqueAlpha, readBytes, readLayers } from 'furrow-files/node'
import { createCommand } from '../command.ts'
import { writeAll } from '../files.ts'
import { checkFolder, checkOutputs } from '../outputs.ts'
import { print } from '../print.ts'
import { withBar } from '../progress.ts'

const WHO = 'furrow array'

interface Options {
  output?: string
  extract?: string
  srgb?: boolean
  compress: Compression
  mipmaps: boolean
  json?: boolean
}

export const arrayCommand = createCommand('array')
  .description('pack or extract a KTX 2 texture array')
  .argument('<files...>', 'images in layer order, or one .ktx2 with --extract')
  .option('-o, --output <file>', 'texture array (.ktx2)')
  .addOption(new Option('--extract <folder>', 'write each layer of an array as PNG').conflicts('output'))
  .option('--srgb', 'the images are sRGB colours (default: linear data)')
  .addOption(
    new Option('--compress <kind>', 'compression; none and zstd are lossless')
      .choices(COMPRESSIONS)
      .default('zstd'),
  )
  .option('--no-mipmaps', 'write no mipmaps (uastc and etc1s only)')
  .option('--json', 'print the result as JSON')
  .addHelpText(
    'after',
    `
Arrays in uastc and etc1s stay compressed on the GPU.

Examples:
  $ furrow array layers/*.png -o layers.ktx2 --compress uastc
  $ furrow array layers.ktx2 --extract layers`,
  )
  .action(packOrExtract)

type Result = NamedArray & { file: string; compression: Compression; bytes: number; gpuBytes?: number }

async function packOrExtract(files: string[], options: Options): Promise<void> {
  const { output, extract } = options
  if (output !== undefined) return printSummary(await packImages(files, output, options), options)
  if (extract !== undefined) return printSummary(await extractLayers(files, extract), options)
  throw new FurrowError({
    code: 'usage',
    who: WHO,
    problem: 'no output',
    limit: 'IMAGES -o ARRAY.ktx2, or ARRAY.ktx2 --extract FOLDER',
    remedy: 'give either -o or --extract',
  })
}

async function packImages(
  files: string[],
  output: string,
  { compress, mipmaps, srgb = false }: Options,
): Promise<Result> {
  await checkOutputs([output], WHO, { extensions: ['.ktx2'], inputs: files })
  const array = await withBar('array', (progress) => readLayers(files, srgb, progress))
  const bytes = await writeArray(array, compress, mipmaps)
  await writeAll([{ path: output, bytes }], WHO)
  const gpuBytes = sizeOnGpu(array, compress, mipmaps)
  return { ...array, file: output, compression: compress, bytes: bytes.length, gpuBytes }
}

async function extractLayers(files: string[], folder: string): Promise<Result> {
  if (files.length > 1) {
    throw new FurrowError({
      code: 'usage',
      who: WHO,
      problem: 'too many files with --extract',
      value: files.length,
      limit: '1',
      remedy: 'extract one array at a time',
    })
  }
  await checkFolder(folder, WHO)
  const { bytes, array } = await readArrayFile(files[0])
  const fileNames = fileNamesOf(array.names)
  const outputs = await Promise.all(
    array.layers.map(async (data, i) => ({
      path: join(folder, `${fileNames[i]}.png`),
      bytes: await encodePngWithoutOpaqueAlpha({ ...array, data }),
    })),
  )
  const paths = outputs.map(({ path }) => path)
  await checkOutputs(paths, WHO, { inputs: files })
  await writeAll(outputs, WHO)
  return { ...array, file: folder, bytes: bytes.length }
}

async function readArrayFile(path: string) {
  const bytes = await readBytes(path, WHO, 'the array')
  try {
    return { bytes, array: await readArray(bytes) }
  } catch (error) {
    const limit = 'KTX 2: 2D, R8 or RGBA8 (plain or Zstandard), UASTC, ETC1S'
    throw cannotRead(WHO, `the array ${path}`, error, { limit, remedy: 'check the file' })
  }
}

/**
 * Returns the size of an array on the GPU, bytes. UASTC is transcoded to ASTC 4x4 or BC7, with 16 bytes per block of 4
 * x 4 texels. ETC1S is transcoded to ETC1 or BC1, with 8 bytes per block.
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

function printSummary(result: Result, { json }: Options): void {
  const { width, height, channels, srgb, names, file, bytes, gpuBytes, compression } = result
  const format = `${channels === 1 ? 'gray' : 'RGBA'}${srgb ? ' sRGB' : ''}, ${compression}`
  const onGpu = gpuBytes === undefined ? '' : `, ${kibibytes(gpuBytes)} on the GPU`
  const count = `${names.length} ${names.length === 1 ? 'layer' : 'layers'}`
  const line = json
    ? JSON.stringify({ file, width, height, layers: names, channels, srgb, compression, bytes, gpuBytes })
    : `${file}: ${count} of ${width} x ${height}, ${format}, ${kibibytes(bytes)} in the file${onGpu}`
  print(line, file)
}

const kibibytes = (bytes: number) => `${(bytes / 1024).toFixed(1)} KiB`
