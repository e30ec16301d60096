/** Rectangle in an image, pixels from the top left. */
export interface Rect {
  left: number
  top: number
  width: number
  height: number
}

/** Minimum difference of a colour channel that counts as a change, 0..255. */
const THRESHOLD = 24
/** Width of the margin, as a fraction of the rectangle's longer side. */
const MARGIN = 0.15

/**
 * Returns the rectangle that contains all pixels that change between images, plus a margin. For pictures of a head in
 * several poses, this is the face. Returns the full image if no pixel changes.
 *
 * @param pictures RGBA bytes of images of equal size, 0..255.
 */
export function changedRect(pictures: readonly Uint8Array[], width: number, height: number): Rect {
  const first = pictures[0]
  let [left, top, right, bottom] = [width, height, -1, -1]
  for (const other of pictures) {
    for (let i = 0; i < other.length; i++) {
      if (Math.abs(other[i] - first[i]) < THRESHOLD) continue
      const [x, y] = [(i >> 2) % width, Math.floor((i >> 2) / width)]
      left = Math.min(left, x)
      right = Math.max(right, x)
      top = Math.min(top, y)
      bottom = Math.max(bottom, y)
    }
  }
  if (right < 0) return { left: 0, top: 0, width, height }
  const margin = Math.round(MARGIN * Math.max(right - left, bottom - top))
  const [x, y] = [Math.max(0, left - margin), Math.max(0, top - margin)]
  return {
    left: x,
    top: y,
    width: Math.min(width, right + margin + 1) - x,
    height: Math.min(height, bottom + margin + 1) - y,
  }
}
