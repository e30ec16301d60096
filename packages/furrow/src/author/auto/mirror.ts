import type { MorphDriver } from '../../drivers/morph/definition.ts'
import { canonicalTargetName } from '../../drivers/morph/target-names.ts'
import { coverTexels } from '../cover-texels.ts'
import type { Spot } from './chart.ts'
import { type FittedRegion, roundWeight } from './links.ts'
import type { Skin, Surface } from './surface.ts'

/** Side of the map on which overlaps are looked for, in texels. */
const SIZE = 256
/** Shares of the covered texture that two triangles, and both sides of the face, may share by chance. */
const CHANCE = 0.05
/** Beyond this far from the middle, in millimetres, both sides have areas of their own. */
const SIDE = 5

/** What a texture does twice. */
export interface Overlap {
  /** Whether left and right half of the face use the same texels. */
  isMirrored: boolean
  /** Share of the texels that are used more than once, 0..1. */
  share: number
}

/** Looks for texels that several places of the skin use. */
export function findOverlap({ uvs, indices }: Skin, { points, corners, triangleOf }: Surface): Overlap {
  const sides = new Uint8Array(SIZE * SIZE)
  const counts = new Uint8Array(SIZE * SIZE)
  for (let t = 0; t < triangleOf.length; t++) {
    const middle = [0, 1, 2].reduce((sum, k) => sum + points[3 * corners[3 * t + k]!]! / 3, 0)
    const vertices = [0, 1, 2].map((k) => indices[3 * triangleOf[t]! + k]!) as [number, number, number]
    coverTexels(uvs, vertices, SIZE, SIZE, (texel, a, b, c) => {
      // Triangles that touch share the texels of their edge.
      if (Math.min(a, b, c) < 1e-3) return
      counts[texel] = Math.min(255, counts[texel]! + 1)
      sides[texel]! |= middle > 0 ? 1 : 2
    })
  }
  let [covered, twice, both] = [0, 0, 0]
  for (let i = 0; i < counts.length; i++) {
    if (counts[i]! > 0) covered++
    if (counts[i]! > 1) twice++
    if (counts[i]! > 1 && sides[i] === 3) both++
  }
  return { share: covered > 0 ? twice / covered : 0, isMirrored: both > CHANCE * covered && both > twice / 2 }
}

/** Whether an overlap is more than chance. */
export function isOverlapped({ share }: Overlap): boolean {
  return share > CHANCE
}

/** For a texture that both sides share: areas of the left side that show on both, each driven by the targets of both. */
export function onBothSides(
  fitted: readonly FittedRegion[],
  names: readonly string[],
  find: (name: string) => number[],
): FittedRegion[] {
  return fitted
    .filter(({ region }) => !region.name.endsWith('Right'))
    .map(({ region, driver, ...rest }) => {
      const name = region.name.replace(/Left$/, '')
      const { share } = region
      const whole = share && (([across, up]: Spot) => share([Math.max(SIDE, across), up]))
      const both = { ...driver, area: name, targets: bothTargets(driver, names, find) }
      return { ...rest, driver: both, region: { ...region, name, ...(whole && { share: whole }) } }
    })
}

/** The triangles of the left side, and what they share with the right one at the middle. */
export function leftTriangles({ points, corners }: Surface): (triangle: number) => boolean {
  return (triangle) => [0, 1, 2].some((k) => points[3 * corners[3 * triangle + k]!]! > 0)
}

/** Each target and the same one of the other side, by half. */
function bothTargets(
  { targets }: MorphDriver,
  names: readonly string[],
  find: (name: string) => number[],
): MorphDriver['targets'] {
  const links = targets.flatMap(({ name, weight = 1 }) => {
    const shape = canonicalTargetName(name)
    const opposite = shape.replace(/(Left|Right)$/, (side) => (side === 'Left' ? 'Right' : 'Left'))
    const [other] = opposite === shape ? [] : find(opposite)
    if (other === undefined) return [{ name, weight }]
    return [name, names[other]!].map((one) => ({ name: one, weight: weight / 2 }))
  })
  return merged(links)
}

function merged(links: MorphDriver['targets']): MorphDriver['targets'] {
  const sums = new Map<string, number>()
  for (const { name, weight = 1 } of links) sums.set(name, (sums.get(name) ?? 0) + weight)
  return [...sums].map(([name, weight]) => ({ name, weight: roundWeight(weight) }))
}
