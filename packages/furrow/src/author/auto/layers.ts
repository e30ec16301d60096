import type { Crease, CreasedRegion } from './crease.ts'
import { NearCreases } from './near.ts'

/** Angle from which on lines of two regions disagree: its cosine. */
const DISAGREE = Math.cos((35 * Math.PI) / 180)

/**
 * Puts regions whose lines cross on different layers, so that one can crease without the other. Left and right, and regions that
 * share their lines, stay together.
 *
 * @param most layers that there may be, 1 to 4; what then still disagrees shares a layer.
 * @returns the layer of each region, from 0.
 */
export function layersOf(regions: readonly CreasedRegion[], most: number): number[] {
  const groups: CreasedRegion[][] = []
  for (const region of regions) {
    const group = groups.find(([first]) => belongTogether(first!, region))
    if (group) group.push(region)
    else groups.push([region])
  }
  const layers: number[] = []
  const nears = new Map(regions.map((region) => [region, nearOf(region)]))
  for (const [i, group] of groups.entries()) {
    const crossed = Array.from({ length: most }, () => 0)
    for (let k = 0; k < i; k++) {
      for (const one of group) {
        for (const other of groups[k]!) crossed[layers[k]!]! += crossings(one, other, nears.get(other)!)
      }
    }
    const free = crossed.indexOf(0)
    layers.push(free >= 0 ? free : crossed.indexOf(Math.min(...crossed)))
  }
  return regions.map((region) => layers[groups.findIndex((group) => group.includes(region))]!)
}

function belongTogether(one: CreasedRegion, other: CreasedRegion): boolean {
  const whole = ({ region }: CreasedRegion) => region.name.replace(/(Left|Right)$/, '')
  return one.creases === other.creases || whole(one) === whole(other)
}

function nearOf({ region, creases }: CreasedRegion): NearCreases {
  const reach = region.reach + region.feather / 2
  return new NearCreases(
    creases,
    creases.map(() => reach),
  )
}

/** Points of one region's lines that lie near the other's, within its reach, and run another way. */
function crossings(one: CreasedRegion, other: CreasedRegion, near: NearCreases): number {
  let count = 0
  for (const { points: p, normals: n } of one.creases) {
    for (let i = 0; i + 5 < p.length; i += 3) {
      const way = [p[i + 3]! - p[i]!, p[i + 4]! - p[i + 1]!, p[i + 5]! - p[i + 2]!] as const
      let crosses = false
      near.visit(p[i]!, p[i + 1]!, p[i + 2]!, n[i]!, n[i + 1]!, n[i + 2]!, (line, _, piece) => {
        crosses ||= cosine(way, other.creases[line]!, piece) < DISAGREE
      })
      if (crosses) count++
    }
  }
  return count
}

/** Of the angle between two lines, which have no sense. */
function cosine([x, y, z]: readonly [number, number, number], { points: p }: Crease, piece: number): number {
  const [u, v, w] = [0, 1, 2].map((k) => p[3 * piece + 3 + k]! - p[3 * piece + k]!) as [
    number,
    number,
    number,
  ]
  return Math.abs(x * u + y * v + z * w) / (Math.hypot(x, y, z) * Math.hypot(u, v, w) || 1)
}
