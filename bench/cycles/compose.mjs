import sharp from 'sharp'

const BACKGROUND = { r: 40, g: 40, b: 40 }
const GAP = 8
/** Rectangle of the forehead, as fractions of a picture's width and height. */
const CROP = { left: 0.22, top: 0.2, width: 0.5, height: 0.26 }

/** Describes how much the activations of two engines differ. */
export function differenceOf(activations, expected) {
  const largest = Math.max(
    ...Object.keys(expected).map((name) => Math.abs(activations[name] - expected[name])),
  )
  return `activations differ from three.js by at most ${largest.toExponential(1)}`
}

/** Writes a figure with the pictures in a row, and an enlarged crop of the forehead below each. `side` is the pictures' size in pixels. */
export async function composeRow(pictures, side, width, path) {
  const part = Object.fromEntries(
    Object.entries(CROP).map(([name, value]) => [name, Math.round(value * side)]),
  )
  const cropHeight = Math.round((width * part.height) / part.width)
  const layers = await Promise.all(
    pictures.flatMap((picture, i) => {
      const left = i * (width + GAP)
      const flat = () => sharp(picture).flatten({ background: BACKGROUND })
      const full = flat().resize(width, width).png().toBuffer()
      const crop = flat().extract(part).resize(width, cropHeight).png().toBuffer()
      return [
        full.then((input) => ({ input, left, top: 0 })),
        crop.then((input) => ({ input, left, top: width + GAP })),
      ]
    }),
  )
  const size = { width: pictures.length * (width + GAP) - GAP, height: width + GAP + cropHeight }
  await sharp({ create: { ...size, channels: 3, background: '#fff' } })
    .composite(layers)
    .jpeg({ quality: 85 })
    .toFile(path)
}
