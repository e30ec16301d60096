/** How wrinkles are drawn as lines by materials that light in steps, see `toonColour` in the reference. */
export const TOON_LINE = {
  /** Slopes, rise over run, between which a line goes from none to full. */
  slopes: [0.05, 0.5],
  /** The colour of a full line is the skin's, times itself, times this. */
  shade: 0.7,
} as const
