/** Wrinkle lines on toon materials, see `toonColour` in the reference. */
export const TOON_LINE = {
  /** Slopes, rise over run, at which a line starts and at which it is full. */
  slopes: [0.05, 0.5],
  /** Factor for the squared skin colour of a full line. */
  shade: 0.7,
} as const
