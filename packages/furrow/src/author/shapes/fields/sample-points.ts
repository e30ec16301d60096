/** Sample positions of displacements in the face frame: a grid over the face, rows along the lids of both eyes, rows along both lips. */

export interface GridPoint {
  u: number
  v: number
}

const GRID_STEP = 0.25
const [LEFT_MOST, LOWEST, COLUMNS, ROWS] = [-2.5, -3.75, 21, 24]

export const GRID: readonly GridPoint[] = Array.from({ length: COLUMNS * ROWS }, (_, i) => ({
  u: LEFT_MOST + GRID_STEP * Math.floor(i / ROWS),
  v: LOWEST + GRID_STEP * (i % ROWS),
}))

/** Row along a lid, at a distance above the upper or below the lower one. */
export const LID_ROWS = [1, -1].flatMap((side) =>
  [1, -1].flatMap((lid) => [0.05, 0.25, 0.5].map((distance) => ({ side, lid, distance }))),
)
/** Samples of a lid row: indices into `ALONG`. */
export const LID_SAMPLES = [0, 2, 4, 6, 8, 10, 12, 14, 16]
/** Extent of the samples, as a fraction of the opening's half width. */
export const LID_REACH = 0.94

/** Row along the upper or lower lip. */
export const LIP_ROWS = [1, -1].flatMap((lip) => [0.1, 0.3].map((distance) => ({ lip, distance })))
export const LIP_SAMPLES = 17

const LIDS = LID_ROWS.length * LID_SAMPLES.length
export const SAMPLES = GRID.length + LIDS + LIP_ROWS.length * LIP_SAMPLES

/** u of each sample on a typical face, to tell left from right. */
export const SAMPLE_U: readonly number[] = [
  ...GRID.map(({ u }) => u),
  ...LID_ROWS.flatMap(({ side }) => LID_SAMPLES.map((_, k) => side * (1 + 0.45 * LID_REACH * (-1 + k / 4)))),
  ...LIP_ROWS.flatMap(() => Array.from({ length: LIP_SAMPLES }, (_, k) => -1 + k / 8)),
]

/** Index of the sample at each sample's mirrored position. */
export const MIRRORED: readonly number[] = [
  ...GRID.map((_, i) => (COLUMNS - 1 - Math.floor(i / ROWS)) * ROWS + (i % ROWS)),
  ...LID_ROWS.flatMap((_, row) => {
    const other = (row + LID_ROWS.length / 2) % LID_ROWS.length
    return LID_SAMPLES.map((_, k) => GRID.length + other * LID_SAMPLES.length + k)
  }),
  ...LIP_ROWS.flatMap((_, row) =>
    Array.from({ length: LIP_SAMPLES }, (_, k) => GRID.length + LIDS + (row + 1) * LIP_SAMPLES - 1 - k),
  ),
]
