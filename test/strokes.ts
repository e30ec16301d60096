/** Points of a straight line across the texture, at a height in it. */
export const across = (v: number, from = 0.1, to = 0.9): [number, number][] => [
  [from, v],
  [to, v],
]
