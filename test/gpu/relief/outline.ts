/** Outline of a drawn object: its left and right end in each row of the picture, pixels from the left; infinite in empty rows. */
export interface Outline {
  left: Float64Array
  right: Float64Array
}

/** Finds the outline of all pixels that are not black. */
export function outlineOf(pixels: Uint8Array, width: number, height: number): Outline {
  const outline = emptyOutline(height)
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) if (pixels[4 * (x + y * width) + 1] > 0) widen(outline, y, x, x + 1)
  }
  return outline
}

/**
 * Computes the outline of a mesh in float64, at the centres of pixel rows.
 *
 * @param project projects a vertex to the picture: x and y in pixels, y up.
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

/** Returns the distances between two outlines in pixels: first between the left ends of all rows, then between the right ends. Skips empty rows. */
export function distances(a: Outline, b: Outline): number[] {
  const found: number[] = []
  for (const side of ['left', 'right'] as const) {
    for (const [row, x] of a[side].entries()) {
      if (Number.isFinite(x) || Number.isFinite(b[side][row])) found.push(Math.abs(x - b[side][row]))
    }
  }
  return found
}

/** Returns the fraction of distances that are at most `limit`. */
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
