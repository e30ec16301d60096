import { AUTO_REGIONS, type AutoSide } from 'furrow/author'
import { AUTO_SIDES, regionStrength, sidesOf } from 'furrow/internal'
import { AUTO_STRENGTHS, type AutoSettings } from './document.ts'
import { splitSide } from './sides.ts'

type Strengths = NonNullable<AutoSettings['strengths']>

const FOREHEAD = AUTO_SIDES.filter((side) => /^forehead(Inner|Outer)(Left|Right)$/.test(side))

/** Returns the halves of regions that an area shows. Empty if the area belongs to no region of automatic wrinkles. */
export function sidesOfArea(area: string): readonly AutoSide[] {
  const [stem, suffix] = splitSide(area)
  const region = AUTO_REGIONS.find((each) => each === stem)
  const sides = region ? sidesOf(region) : []
  return suffix ? sides.filter((side) => side === area) : sides
}

/** Returns the halves of regions that share the lines of an area. All areas of the forehead share lines. */
export function sidesOfLines(area: string): readonly AutoSide[] {
  const sides = sidesOfArea(area)
  return sides.some((side) => FOREHEAD.includes(side)) ? FOREHEAD : sides
}

/** Multiplies the strengths of halves of regions by a factor. */
export function scaleStrengths<Settings extends AutoSettings | undefined>(
  auto: Settings,
  sides: readonly AutoSide[],
  factor: number,
): Settings {
  if (!auto || sides.length === 0) return auto
  const { strengths = {} } = auto
  const scaled = sides.map((side) => [
    side,
    Number((factor * regionStrength(strengths, side)).toPrecision(6)),
  ])
  return { ...auto, strengths: { ...strengths, ...Object.fromEntries(scaled) } }
}

/** Whether new automatic wrinkles can be as deep as the settings demand. */
export function isAllowed({ strengths = {} }: AutoSettings, sides: readonly AutoSide[]): boolean {
  return sides.every((side) => regionStrength(strengths, side) <= AUTO_STRENGTHS[1])
}

/** Limits strengths to the range that `autoWrinkles` accepts. */
export function limited(strengths: Strengths): Strengths {
  const [low, high] = AUTO_STRENGTHS
  return Object.fromEntries(
    Object.entries(strengths).map(([side, value]) => [side, Math.min(high, Math.max(low, value))]),
  )
}
