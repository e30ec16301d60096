import { cos } from '../../../math/elementary.ts'
import { dot, length } from '../../../math/vector.ts'
import type { SkinLine } from '../../strokes/curve.ts'
import { LineGrid } from '../../strokes/line-grid.ts'
import type { CreasedRegion } from '../lines/crease.ts'

/** Two nearby lines count as crossing if the angle between them is at least 35 degrees. */
const CROSSING = cos((35 * Math.PI) / 180)

/**
 * Assigns regions of skin to layers. Regions whose wrinkle lines cross get different layers: an area of influence shows all lines of its
 * layer, so it would also show the lines that cross its own lines. The left and the right region of a pair, and regions that share lines,
 * get the same layer.
 *
 * @param maxLayers maximum number of layers, 1..4. If the lines of a region cross lines in every layer, the region gets the layer with
 * the fewest crossings.
 * @returns index of each region's layer.
 */
export function assignLayers(regions: readonly CreasedRegion[], maxLayers: number): number[] {
  const groups: CreasedRegion[][] = []
  for (const region of regions) {
    const group = groups.find(([first]) => shareLayer(first, region))
    if (group) group.push(region)
    else groups.push([region])
  }
  const grids = groups.map((group) => group.map(gridOf))
  const layers: number[] = []
  for (const [i, group] of groups.entries()) {
    const crossings = Array.from({ length: maxLayers }, () => 0)
    for (let k = 0; k < i; k++) {
      for (const region of group) {
        for (const [n, other] of groups[k].entries())
          crossings[layers[k]] += countCrossings(region, other, grids[k][n])
      }
    }
    const free = crossings.indexOf(0)
    layers.push(free >= 0 ? free : crossings.indexOf(Math.min(...crossings)))
  }
  return regions.map((region) => layers[groups.findIndex((group) => group.includes(region))])
}

function shareLayer(a: CreasedRegion, b: CreasedRegion): boolean {
  const withoutSide = ({ region }: CreasedRegion) => region.name.replace(/(Left|Right)$/, '')
  return a.creases === b.creases || withoutSide(a) === withoutSide(b)
}

function gridOf({ region, creases }: CreasedRegion): LineGrid {
  const reach = region.reach + region.feather / 2
  return new LineGrid(
    creases,
    creases.map(() => reach),
  )
}

/** Counts the points of a region's lines at which a line of another region is near and has a different direction. */
function countCrossings({ creases }: CreasedRegion, other: CreasedRegion, grid: LineGrid): number {
  let count = 0
  for (const crease of creases) {
    const { points: p, normals: n } = crease
    for (let i = 0; i + 5 < p.length; i += 3) {
      let crosses = false
      grid.visit(p.subarray(i, i + 3), n.subarray(i, i + 3), (line, _, segment) => {
        crosses ||= cosineBetween(crease, i / 3, other.creases[line], segment) < CROSSING
      })
      if (crosses) count++
    }
  }
  return count
}

function cosineBetween(one: SkinLine, i: number, other: SkinLine, k: number): number {
  readSegment(a, one, i)
  readSegment(b, other, k)
  return Math.abs(dot(a, b)) / (length(a) * length(b) || 1)
}

const [a, b] = [new Float64Array(3), new Float64Array(3)]

function readSegment(out: Float64Array, { points }: SkinLine, segment: number): void {
  for (let k = 0; k < 3; k++) out[k] = points[3 * segment + 3 + k] - points[3 * segment + k]
}
