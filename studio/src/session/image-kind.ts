import type { RgbaImage } from 'furrow'

/** Uses of an image that the user drops: the weights of a region, or a map of a layer. */
export const IMAGE_KINDS = ['mask', 'normal', 'height', 'baseColor'] as const
export type ImageKind = (typeof IMAGE_KINDS)[number]

/** Words of a file's name that tell its kind. */
const WORDS: Record<ImageKind, RegExp> = {
  mask: /^(mask|area|weights?)$/,
  normal: /^(normals?|nrm|nor)$/,
  height: /^(heights?|displacement|disp|bump)$/,
  baseColor: /^(colou?r|albedo|diffuse)$/,
}
/** Minimum by which the mean blue of a normal map exceeds its mean red and green, 0..255. Flat normals are 128, 128, 255. */
const BLUISH = 40
/** Maximum mean difference between the channels of a gray image, 0..255. JPEG files are not exactly gray. */
const GRAY = 4
/** Maximum number of texels that are read. */
const SAMPLES = 65_536

/** Guesses the kind of an image. The last word in the file's name that tells a kind decides, otherwise the colours do. */
export function guessKind(fileName: string, image: RgbaImage): ImageKind {
  return kindOfName(fileName) ?? kindOfColours(image)
}

function kindOfName(fileName: string): ImageKind | undefined {
  const words = fileName
    .replace(/\.[^.]+$/, '')
    .replace(/([a-z])([A-Z])/g, '$1 $2')
    .toLowerCase()
    .split(/[^a-z]+/)
  for (const word of words.reverse()) {
    const kind = IMAGE_KINDS.find((each) => WORDS[each].test(word))
    if (kind) return kind
  }
  return undefined
}

function kindOfColours({ width, height, data }: RgbaImage): ImageKind {
  const count = width * height
  const step = Math.ceil(count / SAMPLES)
  const sums = [0, 0, 0]
  let [difference, samples] = [0, 0]
  for (let i = 0; i < count; i += step) {
    const texel = [data[4 * i], data[4 * i + 1], data[4 * i + 2]]
    for (let k = 0; k < 3; k++) sums[k] += texel[k]
    difference += Math.max(...texel) - Math.min(...texel)
    samples++
  }
  const [red, green, blue] = sums.map((sum) => sum / samples)
  if (difference / samples <= GRAY) return 'mask'
  return blue - Math.max(red, green) >= BLUISH ? 'normal' : 'baseColor'
}
