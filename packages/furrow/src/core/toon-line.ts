/** Constants of the dark lines that wrinkles draw on toon materials; see `toonColour` in `reference.ts`. */
export const TOON_LINE = {
  /** Changes of slope (rise over run) at which darkening starts and at which it is complete. */
  slopes: [0.05, 0.5],
  /** Darkest colour of a line: `shade * colour * colour`, in linear RGB. */
  shade: 0.7,
} as const
