import type { GrayImage } from '../../../core/types.ts'
import { smoothstep } from '../../../math/scalar.ts'
import type { SkinTexels } from '../../skin/skin-texels.ts'
import type { SkinLine } from '../../strokes/curve.ts'
import { LineGrid } from '../../strokes/line-grid.ts'
import type { SkinRegion } from '../anatomy/region.ts'
import { type HeadChart, unroll } from '../surface/head-chart.ts'
import { visibility } from './visibility.ts'

/** Two areas blend at texels whose distances to the lines of the two areas differ by at most half of this value, in millimetres. */
const TRANSITION = 4

/** Lines of a region, and the size of the area around them. */
export interface AreaSource {
  region: Pick<SkinRegion, 'reach' | 'feather' | 'influence' | 'isOffHead'>
  creases: readonly SkinLine[]
}

/**
 * Draws the areas of influence of the regions in one layer. An area surrounds the wrinkle lines of its region, and fades out where the lines
 * of another region are nearer.
 *
 * @param chart chart of a face. If given, hidden skin (such as inside the mouth) gets no weight.
 * @returns weights of each region's area, 255 = fully visible.
 */
export function drawAreas(
  texels: SkinTexels,
  regions: readonly AreaSource[],
  chart?: HeadChart,
): GrayImage[] {
  const { width, height } = texels
  const images = regions.map(() => new Uint8Array(width * height))
  // Lines that several regions share are assigned to the first of these regions, the owner.
  const owners = regions.map(({ creases }) => regions.findIndex((other) => other.creases === creases))
  const lines = regions.flatMap(({ creases }, i) =>
    owners[i] === i ? creases.map((crease) => ({ crease, owner: i })) : [],
  )
  const extents = regions.map(({ region }) => region.reach + region.feather)
  const grid = new LineGrid(
    lines.map(({ crease }) => crease),
    lines.map(({ owner }) => 2 * extents[owner]),
  )
  /** Distance from the current texel to the nearest line of each owner. */
  const distances = new Float64Array(regions.length)
  texels.visitNear(grid.isNear, (texel, position, normal) => {
    distances.fill(Infinity)
    grid.visit(position, normal, (line, distance) => {
      const { owner } = lines[line]
      distances[owner] = Math.min(distances[owner], distance)
    })
    if (regions.every((_, i) => distances[owners[i]] >= extents[i])) return
    const [x, y, z] = [position[0], position[1], position[2]]
    const point = unroll(x, y, z)
    const visible = chart ? visibility(chart, x, y, z, normal) : 1
    for (let i = 0; i < regions.length; i++) {
      const own = distances[owners[i]]
      if (own >= extents[i]) continue
      const { region } = regions[i]
      let other = Infinity
      for (let k = 0; k < distances.length; k++) if (k !== owners[i]) other = Math.min(other, distances[k])
      const inside = 1 - smoothstep((own - region.reach) / region.feather)
      const nearer = other === Infinity ? 1 : smoothstep((other - own) / TRANSITION + 0.5)
      const shown = region.isOffHead ? 1 : visible
      images[i][texel] = Math.round(255 * inside * nearer * shown * (region.influence?.(point) ?? 1))
    }
  })
  return images.map((data) => ({ width, height, data }))
}
