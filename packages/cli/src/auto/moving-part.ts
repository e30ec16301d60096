/** A part of a picture in pixels. */
export interface Part {
  left: number
  top: number
  width: number
  height: number
}

/** Difference of a channel from which on a pixel counts as another. */
const OTHER = 24
/** What is shown round it, as a share of its longer side. */
const MARGIN = 0.15

/**
 * The part of some pictures of one size in which they differ, with a margin: of a face in several poses, the face.
 *
 * @param pictures RGBA bytes.
 */
export function movingPart(pictures: readonly Uint8Array[], width: number, height: number): Part {
  const first = pictures[0]
  let [left, top, right, bottom] = [width, height, -1, -1]
  for (const other of pictures) {
    for (let i = 0; i < other.length; i++) {
      if (Math.abs(other[i] - first[i]) < OTHER) continue
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
