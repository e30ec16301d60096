import type { WrinkleDriver } from 'furrow'
import { power } from 'furrow/internal'
import { powerCurve } from '../power-curve.ts'
import type { RuleStrengths } from './region-settings.ts'
import { CORRECTION, RULES, type Rule, type Side } from './rules.ts'
import type { ShapeLink } from './shapes.ts'

/** Name of the area of a rule. */
export function areaNameOf({ key, isSided }: Rule, side: Side): string {
  return isSided ? `${key}_${side}` : key
}

/** Name of the area that keeps the value of a rule before the overlap of brow rules is subtracted. It has no wrinkles. */
export function inputAreaOf(key: string, side: Side): string {
  return `${key}_${side} input`
}

/** Rules whose value passes through an input area. */
export function isCorrected({ key }: Rule): boolean {
  return (CORRECTION.rules as readonly string[]).includes(key)
}

/**
 * Creates the drivers of the rules.
 *
 * @param links blendshapes of the face. If there are none, inputs with the names of the rules drive the areas.
 * @param shapeOf returns the function that replaces the flow map of a set, see `OnsetFit`.
 */
export function characterDrivers(
  links: readonly ShapeLink[],
  strengths: RuleStrengths,
  shapeOf: (set: number) => (value: number) => number,
): WrinkleDriver[] {
  const sides = (rule: Rule): Side[] => (rule.isSided ? ['L', 'R'] : ['L'])
  const drivers: WrinkleDriver[] = []
  for (const rule of RULES) {
    for (const side of sides(rule)) {
      const area = areaNameOf(rule, side)
      const corrected = CORRECTION.rules.map((key) => inputAreaOf(key, side))
      if (rule.key === CORRECTION.to) {
        const areas = corrected.map((name) => ({ name, weight: 1 }))
        drivers.push({ type: 'area', area, areas, rule: 'min', curve: powerCurve(1, 1, shapeOf(rule.set)) })
        continue
      }
      if (isCorrected(rule)) {
        const own = inputAreaOf(rule.key, side)
        const areas = corrected.map((name) => ({ name, weight: name === own ? 1 : -1 }))
        drivers.push(...ruleDrivers(rule, side, own, links, strengths))
        drivers.push({ type: 'area', area, areas, rule: 'sum', curve: powerCurve(1, 1, shapeOf(rule.set)) })
        continue
      }
      drivers.push(...ruleDrivers(rule, side, area, links, strengths, shapeOf(rule.set)))
    }
  }
  return drivers
}

/** Creates the driver that computes the value of a rule from blendshapes. Without a blendshape, the rule has no driver. */
function ruleDrivers(
  rule: Rule,
  side: Side,
  area: string,
  links: readonly ShapeLink[],
  { overall, weightOf, powerOf }: RuleStrengths,
  shape?: (value: number) => number,
): WrinkleDriver[] {
  const weight = weightOf(rule, side)
  if (links.length === 0) {
    const curve = powerCurve(overall * power(weight, powerOf(rule)), powerOf(rule), shape)
    return [{ type: 'input', name: rule.names[side], area, curve }]
  }
  const own = links.filter((link) => link.rule === rule.key && link.side === side)
  if (own.length === 0) return []
  const targets = own.map(({ shape: name, factor }) => ({ name, weight: factor * weight }))
  return [{ type: 'morph', area, targets, rule: 'sum', curve: powerCurve(overall, powerOf(rule), shape) }]
}
