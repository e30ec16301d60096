/**
 * Points at which the displacements of blendshapes are sampled: a grid over the face, rows along the lids of both eyes, and rows along both
 * lips. Their order is grid, lids, lips. Coordinates are those of `FaceFrame`: the eyes are at u = -1 and u = 1, and v grows upwards.
 */

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

/**
 * Rows along the lids. `side` is 1 for the left eye, -1 for the right eye. `lid` is 1 for rows above the edge of the upper lid, -1 for rows
 * below the edge of the lower lid. `distance` is the distance from this edge along v.
 */
export const LID_ROWS = [1, -1].flatMap((side) =>
  [1, -1].flatMap((lid) => [0.05, 0.25, 0.5].map((distance) => ({ side, lid, distance }))),
)
/** Samples in a row along a lid, as indices into `ALONG` of `openings.ts`. */
export const LID_SAMPLES = [0, 2, 4, 6, 8, 10, 12, 14, 16]
/** Distance of the outermost samples from the middle of the eye, as a fraction of half the eye's width. */
export const LID_REACH = 0.94

/**
 * Rows along the lips. `lip` is 1 for rows above the line between the lips, -1 for rows below it. `distance` is the distance from the line
 * along v.
 */
export const LIP_ROWS = [1, -1].flatMap((lip) => [0.1, 0.3].map((distance) => ({ lip, distance })))
export const LIP_SAMPLES = 17

const LIDS = LID_ROWS.length * LID_SAMPLES.length
export const SAMPLES = GRID.length + LIDS + LIP_ROWS.length * LIP_SAMPLES

/** Coordinate u of each sample on a typical face. It is positive on the person's left. */
export const SAMPLE_U: readonly number[] = [
  ...GRID.map(({ u }) => u),
  ...LID_ROWS.flatMap(({ side }) => LID_SAMPLES.map((_, k) => side * (1 + 0.45 * LID_REACH * (-1 + k / 4)))),
  ...LIP_ROWS.flatMap(() => Array.from({ length: LIP_SAMPLES }, (_, k) => -1 + k / 8)),
]

/** For each sample, the index of the sample at its mirrored position. */
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
