import { weldSurface } from '../../../../packages/furrow/src/author/skin/surface.ts'

/** Width and height of the sheet, millimetres. */
export const SIDE = 80
/** Fraction of length that the sheet loses. */
export const COMPRESSION = 0.2

/** Returns a flat sheet of n x n squares, and the offsets that shorten it along a direction. */
export function sheet(n: number, degrees: number) {
  const [cosine, sine] = [Math.cos((degrees * Math.PI) / 180), Math.sin((degrees * Math.PI) / 180)]
  const [positions, uvs, indices, offsets]: number[][] = [[], [], [], []]
  for (let j = 0; j <= n; j++) {
    for (let i = 0; i <= n; i++) {
      const [x, y] = [(i / n) * SIDE, (j / n) * SIDE]
      positions.push(x, y, 0)
      uvs.push(i / n, 1 - j / n)
      const along = (x - SIDE / 2) * cosine + (y - SIDE / 2) * sine
      offsets.push(-COMPRESSION * along * cosine, -COMPRESSION * along * sine, 0)
      const p = j * (n + 1) + i
      if (i < n && j < n) indices.push(p, p + 1, p + n + 2, p, p + n + 2, p + n + 1)
    }
  }
  return { surface: weldSurface({ positions, indices }), positions, uvs, indices, offsets, cosine, sine }
}
