/** Where displacements are sampled, in the frame of the face: a grid over it, rows along the lids of both eyes, rows along both lips. */

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

/** A row along a lid, some distance above the upper or below the lower one. */
export const LID_ROWS = [1, -1].flatMap((side) =>
  [1, -1].flatMap((lid) => [0.05, 0.25, 0.5].map((distance) => ({ side, lid, distance }))),
)
/** Samples of such a row: indices into `ALONG`. */
export const LID_SAMPLES = [0, 2, 4, 6, 8, 10, 12, 14, 16]
/** How far along the half width of the opening the samples reach. */
export const LID_REACH = 0.94

/** A row along the upper or lower lip. */
export const LIP_ROWS = [1, -1].flatMap((lip) => [0.1, 0.3].map((distance) => ({ lip, distance })))
export const LIP_SAMPLES = 17

const LIDS = LID_ROWS.length * LID_SAMPLES.length
export const SAMPLES = GRID.length + LIDS + LIP_ROWS.length * LIP_SAMPLES

/** u of each sample on a typical face, for telling left from right. */
export const SAMPLE_U: readonly number[] = [
  ...GRID.map(({ u }) => u),
  ...LID_ROWS.flatMap(({ side }) => LID_SAMPLES.map((_, k) => side * (1 + 0.45 * LID_REACH * (-1 + k / 4)))),
  ...LIP_ROWS.flatMap(() => Array.from({ length: LIP_SAMPLES }, (_, k) => -1 + k / 8)),
]

/** The sample at the mirrored position of each. */
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
