import type { ImageArray } from './image-array.ts'

/** A rectangle of texels: columns `x0` to `x1 - 1` and rows `y0` to `y1 - 1`. It is empty if `x1 <= x0`. */
export interface Bounds {
  x0: number
  y0: number
  x1: number
  y1: number
}

/** Extends the rectangle `bounds` to contain another rectangle. */
export function widen(bounds: Bounds, { x0, y0, x1, y1 }: Readonly<Bounds>): void {
  bounds.x0 = Math.min(bounds.x0, x0)
  bounds.y0 = Math.min(bounds.y0, y0)
  bounds.x1 = Math.max(bounds.x1, x1)
  bounds.y1 = Math.max(bounds.y1, y1)
}

/** Returns a rectangle with a margin around it, clipped to the rectangle `whole`. */
export function grown({ x0, y0, x1, y1 }: Readonly<Bounds>, margin: number, whole: Readonly<Bounds>): Bounds {
  return {
    x0: Math.max(x0 - margin, whole.x0),
    y0: Math.max(y0 - margin, whole.y0),
    x1: Math.min(x1 + margin, whole.x1),
    y1: Math.min(y1 + margin, whole.y1),
  }
}

/** Returns the bounding rectangle of the texels above 0 in one slice of a single-channel array. Without such texels, it is empty. */
export function boundsOf({ width, height, data }: ImageArray, slice: number): Bounds {
  const bounds = { x0: width, y0: height, x1: 0, y1: 0 }
  const start = slice * width * height
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      if (data[start + y * width + x] === 0) continue
      bounds.x0 = Math.min(bounds.x0, x)
      bounds.x1 = Math.max(bounds.x1, x + 1)
      bounds.y0 = Math.min(bounds.y0, y)
      bounds.y1 = y + 1
    }
  }
  return bounds
}
