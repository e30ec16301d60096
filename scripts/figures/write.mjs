import { mkdir, rename } from 'node:fs/promises'
import { dirname } from 'node:path'

/** Gap between pictures, pixels. */
export const GAP = 8

/** Writes rows of pictures of equal size to an image file. Gaps are transparent, or white in JPEG. */
export async function writeSheet(pictures, file) {
  const image = await arrange(pictures)
  await write(
    file.endsWith('.jpg')
      ? image.flatten({ background: '#fff' }).jpeg({ quality: 86, mozjpeg: true })
      : image.png({ compressionLevel: 9 }),
    file,
  )
}

/**
 * Writes an animated WebP that repeats forever. `frames` selects the pictures that each frame shows side by side.
 */
export async function writeMoving(pictures, frames, file) {
  const { default: sharp } = await import('sharp')
  const drawn = new Map()
  for (const { pictures: shown } of frames) {
    const key = String(shown)
    if (drawn.has(key)) continue
    const image = await arrange(shown.map((k) => pictures[k]))
    drawn.set(key, await image.flatten({ background: '#fff' }).png().toBuffer())
  }
  const images = frames.map(({ pictures: shown }) => drawn.get(String(shown)))
  const moving = sharp(images, { join: { animated: true } })
  await write(moving.webp({ quality: 76, effort: 6, loop: 0, delay: frames.map(({ delay }) => delay) }), file)
}

async function arrange(pictures) {
  const { default: sharp } = await import('sharp')
  const [{ crop, scale = 1 }] = pictures
  const [width, height] = [crop.width, crop.height].map((side) => Math.round(side * scale))
  let [left, top, right] = [0, 0, 0]
  const layers = []
  for (const [i, { beginsRow, crop, pixels, ...size }] of pictures.entries()) {
    if (i > 0 && beginsRow) [left, top] = [0, top + height + GAP]
    const full = sharp(pixels, { raw: { width: size.width, height: size.height, channels: 4 } })
    layers.push({ input: await full.extract(crop).resize(width, height).png().toBuffer(), left, top })
    right = Math.max(right, left + width)
    left += width + GAP
  }
  const background = { r: 255, g: 255, b: 255, alpha: 0 }
  const canvas = sharp({ create: { width: right, height: top + height, channels: 4, background } })
  return sharp(await canvas.composite(layers).png().toBuffer())
}

async function write(image, file) {
  await mkdir(dirname(file), { recursive: true })
  await image.toFile(`${file}.tmp`)
  await rename(`${file}.tmp`, file)
}
