/** Where an outline begins and ends in each row of a picture, in pixels from its left; infinite where there is none. */
export interface Outline {
  left: Float64Array
  right: Float64Array
}

/** The outline of what is drawn over black. */
export function outlineOf(pixels: Uint8Array, width: number, height: number): Outline {
  const outline = emptyOutline(height)
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) if (pixels[4 * (x + y * width) + 1] > 0) widen(outline, y, x, x + 1)
  }
  return outline
}

/**
 * The outline of a mesh in float64, at the centres of the rows.
 *
 * @param project x and y in pixels of a vertex, upwards.
 */
export function projectedOutline(
  triangles: ArrayLike<number>,
  project: (vertex: number) => readonly [number, number],
  height: number,
): Outline {
  const outline = emptyOutline(height)
  for (let k = 0; k < triangles.length; k++) {
    const [x0, y0] = project(triangles[k])
    const [x1, y1] = project(triangles[k % 3 === 2 ? k - 2 : k + 1])
    const [first, last] = [Math.ceil(Math.min(y0, y1) - 0.5), Math.floor(Math.max(y0, y1) - 0.5)]
    for (let row = Math.max(first, 0); row <= Math.min(last, height - 1) && y0 !== y1; row++) {
      const x = x0 + ((row + 0.5 - y0) / (y1 - y0)) * (x1 - x0)
      widen(outline, row, x, x)
    }
  }
  return outline
}

/** Distances between two outlines in pixels, of each row that either has; by those on the left, then those on the right. */
export function distances(a: Outline, b: Outline): number[] {
  const found: number[] = []
  for (const side of ['left', 'right'] as const) {
    for (const [row, x] of a[side].entries()) {
      if (Number.isFinite(x) || Number.isFinite(b[side][row])) found.push(Math.abs(x - b[side][row]))
    }
  }
  return found
}

/** The fraction of distances that are no more than a limit. */
export function fractionWithin(limit: number, found: readonly number[]): number {
  return found.filter((distance) => distance <= limit).length / found.length
}

function emptyOutline(height: number): Outline {
  return { left: new Float64Array(height).fill(Infinity), right: new Float64Array(height).fill(-Infinity) }
}

function widen({ left, right }: Outline, row: number, from: number, to: number): void {
  left[row] = Math.min(left[row], from)
  right[row] = Math.max(right[row], to)
}
