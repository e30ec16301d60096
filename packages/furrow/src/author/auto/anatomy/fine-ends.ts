import { atan2, cos, sin } from '../../../math/elementary.ts'
import type { Rng } from '../../../math/rng.ts'
import { length2 } from '../../../math/vector.ts'
import type { ChartPoint } from '../surface/head-chart.ts'
import { type Guide, sampleCurve } from './region.ts'

/** Where a fine line leaves another, as a fraction of its length from the end, and at what angle in radians. */
const LEAVES = [0.16, 0.34] as const
const ANGLE = [0.13, 0.3] as const
/** Its length in millimetres, and as a fraction of the other's at most. */
const LENGTH = [7, 13] as const
const LONGEST = 0.45
/** Its width and depth as fractions of the other's. */
const WIDTH = 0.7
const DEPTH = [0.3, 0.5] as const
const POINTS = 8

/**
 * Lines with finer ones that leave them near their ends, to either side: a crease of skin does not stop, it runs out into the furrows round it.
 *
 * @param fraction of the ends that have one, 0..1.
 */
export function withFineEnds(guides: readonly Guide[], fraction: number, rng: Rng): Guide[] {
  return guides.flatMap((guide) => {
    const reversed = { ...guide, path: guide.path.toReversed() }
    const ends = [guide, reversed].flatMap((from) => (rng.next() < fraction ? [fineEnd(from, rng)] : []))
    return [guide, ...ends]
  })
}

/** A fine line that leaves a guide before the last of its points. */
function fineEnd({ path, width, depth, softness }: Guide, rng: Rng): Guide {
  const last = path.length - 1
  const leaves = Math.max(1, Math.round((1 - rng.uniform(...LEAVES)) * last))
  const [start, before] = [path[leaves], path[leaves - 1]]
  const heading = atan2(start[1] - before[1], start[0] - before[0])
  const turn = (rng.next() < 0.5 ? -1 : 1) * rng.uniform(...ANGLE)
  const length = Math.min(rng.uniform(...LENGTH), LONGEST * lengthOf(path))
  return {
    path: sampleCurve(POINTS, (t): ChartPoint => {
      // It turns away gradually, so that it leaves the other line without a corner.
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
