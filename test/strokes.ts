/** Returns the points of a straight horizontal line at the texture coordinate `v`. */
export const across = (v: number, from = 0.1, to = 0.9): [number, number][] => [
  [from, v],
  [to, v],
]

/** Strokes document with one wrinkle line. */
export const ONE_LINE = {
  version: 1,
  strokes: [{ group: 'brow', points: across(0.8), width: 4, depth: 0.5 }],
}
