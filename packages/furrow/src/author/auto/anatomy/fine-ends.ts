import { atan2, cos, sin } from '../../../math/elementary.ts'
import type { Rng } from '../../../math/rng.ts'
import { length2 } from '../../../math/vector.ts'
import type { ChartPoint } from '../surface/head-chart.ts'
import { type Guide, sampleCurve } from './region.ts'

// A fine line (branch) starts near the end of another line (stem). Pairs are the minimum and maximum of a random value.
/** Distance from the stem's end to the start of the branch, as a fraction of the stem's length. */
const BRANCH_START = [0.16, 0.34] as const
/** Angle between branch and stem in radians. */
const ANGLE = [0.13, 0.3] as const
/** Length of a branch in millimetres. */
const LENGTH = [7, 13] as const
/** Maximum length of a branch as a fraction of the stem's length. */
const MAX_LENGTH_RATIO = 0.45
/** Width of a branch as a fraction of the stem's width. */
const WIDTH = 0.7
/** Depth of a branch as a fraction of the stem's depth. */
const DEPTH = [0.3, 0.5] as const
/** Number of points of a branch. */
const POINTS = 8

/**
 * Adds fine lines that branch off near the ends of lines, because a real crease does not stop but fades into fine furrows.
 *
 * @param fraction fraction of the ends that get a fine line, 0..1.
 */
export function withFineEnds(guides: readonly Guide[], fraction: number, rng: Rng): Guide[] {
  return guides.flatMap((guide) => {
    const reversed = { ...guide, path: guide.path.toReversed() }
    const ends = [guide, reversed].flatMap((from) => (rng.next() < fraction ? [fineEnd(from, rng)] : []))
    return [guide, ...ends]
  })
}

/** Creates a fine line that branches off before a guide's last point. */
function fineEnd({ path, width, depth, softness }: Guide, rng: Rng): Guide {
  const last = path.length - 1
  const leaves = Math.max(1, Math.round((1 - rng.uniform(...BRANCH_START)) * last))
  const [start, before] = [path[leaves], path[leaves - 1]]
  const heading = atan2(start[1] - before[1], start[0] - before[0])
  const turn = (rng.next() < 0.5 ? -1 : 1) * rng.uniform(...ANGLE)
  const length = Math.min(rng.uniform(...LENGTH), MAX_LENGTH_RATIO * lengthOf(path))
  return {
    path: sampleCurve(POINTS, (t): ChartPoint => {
      // Turn gradually, so that the branch starts in the direction of the stem.
      const angle = heading + turn * t
      return [start[0] + t * length * cos(angle), start[1] + t * length * sin(angle)]
    }),
    width: WIDTH * width,
    depth: depth * rng.uniform(...DEPTH),
    taper: [0.2, 0.7],
    shoulder: [0.8, 0.8],
    softness,
  }
}

function lengthOf(path: readonly ChartPoint[]): number {
  return path.slice(1).reduce((sum, [x, y], i) => sum + length2(x - path[i][0], y - path[i][1]), 0)
}
