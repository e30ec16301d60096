import { parse } from 'node:path'
import { type ErrorCode, FurrowError } from 'furrow'
import type { RgbaImage } from 'furrow/author'
import { fileNamesOf, isFileName, MAX_AREAS } from 'furrow/internal'
import { cannotRead } from '../base/errors.ts'
import { statOf } from '../disk/file-status.ts'
import { readBytes } from '../disk/read-bytes.ts'
import { EXACT_IMAGES } from '../images/check-image.ts'
import { checkDecodedBytes } from '../images/decoded-bytes.ts'
import { withImageErrors } from '../images/image-errors.ts'
import { openImage } from '../images/open-image.ts'
import type { NamedArray } from './image-array.ts'

const WHO = 'furrow array'

const MISSING = Object.assign(new Error('no such file'), { code: 'ENOENT' })

/**
 * Reads images as layers of a texture array. Layers get the names of the files without extensions. Ignores colour
 * profiles. The array has one channel if `srgb` is false and all images are gray and opaque.
 *
 * @throws FurrowError if an image cannot be read, has more than 8 bits per channel, or differs in size from the first.
 */
export async function readLayers(
  paths: readonly string[],
  srgb: boolean,
  progress?: (done: number, total: number) => void,
): Promise<NamedArray> {
  const names = paths.map((path) => parse(path).name)
  // Checks existence before names. A shell pattern without matches, e.g. `*.png`, should fail as a missing file, not as
  // an invalid name.
  for (const path of paths) if (!(await statOf(path))) throw cannotRead(WHO, `the image ${path}`, MISSING)
  checkNames(names, paths)
  const images: RgbaImage[] = []
  for (const [i, path] of paths.entries()) {
    const image = await readImage(path)
    const first = images.at(0) ?? image
    if (image.width !== first.width || image.height !== first.height) {
      const limit = `${first.width} x ${first.height}, the size of ${paths[0]}`
      fail(
        `${path} has a different size`,
        `${image.width} x ${image.height}`,
        limit,
        'scale all images to one size',
      )
    }
    if (i === 0) checkDecodedBytes(image.data.length * paths.length, 'the array', WHO)
    images.push(image)
    progress?.(i + 1, paths.length)
  }
  const { width, height } = images[0]
  // WebGPU and WebGL have no gray sRGB format.
  const gray = !srgb && images.every(({ data }) => isGray(data))
  const layers = images.map(({ data }) => (gray ? data.filter((_, i) => i % 4 === 0) : data))
  return { width, height, channels: gray ? 1 : 4, srgb, names, layers }
}

function checkNames(names: readonly string[], paths: readonly string[]): void {
  if (names.length < 1 || names.length > MAX_AREAS) {
    fail(
      'number of images out of range',
      names.length,
      `1 to ${MAX_AREAS}`,
      'make several arrays',
      'out-of-range',
    )
  }
  for (const [i, name] of names.entries()) {
    const other = names.indexOf(name)
    if (other < i) {
      fail(
        'two layers with the same name',
        name,
        `different names for ${paths[other]} and ${paths[i]}`,
        'rename one file',
      )
    }
    if (!isFileName(name)) {
      fail('invalid layer name', name, `e.g. ${fileNamesOf([name])}`, 'rename the file')
    }
  }
}

async function readImage(path: string): Promise<RgbaImage> {
  const opened = await openImage(await readBytes(path, WHO, 'the image'), path, WHO, EXACT_IMAGES)
  const { image, depth } = opened
  if (depth !== 'uchar') {
    fail(`unsupported bit depth of ${path}`, depth, '8 bits per channel', 'save it in 8 bits')
  }
  const raw = image.toColourspace('srgb').ensureAlpha().raw()
  const { data, info } = await withImageErrors(path, WHO, () => raw.toBuffer({ resolveWithObject: true }))
  return { width: info.width, height: info.height, data }
}

function isGray(rgba: Uint8Array): boolean {
  for (let i = 0; i < rgba.length; i += 4) {
    if (rgba[i] !== rgba[i + 1] || rgba[i] !== rgba[i + 2] || rgba[i + 3] !== 255) return false
  }
  return true
}

function fail(problem: string, value: unknown, limit: string, remedy: string, code?: ErrorCode): never {
  throw new FurrowError({ code, who: WHO, problem, value, limit, remedy })
}
