import type { FaceToImport } from '../face-maps.ts'
import type { CharacterWrinkles } from './read-character.ts'
import { REGIONS, type Rule, type Side } from './rules.ts'

/** Strength and power of the rules. */
export interface RuleStrengths {
  /** Factor of all activations. */
  overall: number
  /** Returns the factor by which a rule's value is multiplied before the exponent is applied. */
  weightOf(rule: Rule, side: Side): number
  /** Returns the exponent of a rule. */
  powerOf(rule: Rule): number
}

/** Range of the exponents, as in the add-on. */
export const POWER_RANGE = { min: 0.25, max: 2 } as const

/**
 * Returns strengths and powers. The add-on for Blender stores the user's settings as custom properties of the mesh object. A glTF file has them
 * if it was exported with custom properties. They override the weights in the JSON file. The JSON file has no powers.
 *
 * @param powers exponents by region, or for `all`.
 */
export function ruleStrengths(
  { weights, overallWeight }: CharacterWrinkles,
  face: FaceToImport,
  powers: Readonly<Record<string, number>>,
): RuleStrengths {
  const { wrinkle_strength: strength, wrinkle_regions: regions, wrinkle_curves: curves } = propertiesOf(face)
  const regionWeights = numbersOf(regions)
  const regionPowers = numbersOf(curves)
  return {
    overall: typeof strength === 'number' && strength >= 0 ? strength : overallWeight,
    weightOf: ({ names, region }, side) => regionWeights?.[region - 1] ?? weights.get(names[side]) ?? 1,
    powerOf: ({ region }) => {
      const power = powers[REGIONS[region - 1]] ?? powers.all ?? regionPowers?.[region - 1] ?? 1
      return Math.min(POWER_RANGE.max, Math.max(POWER_RANGE.min, power))
    },
  }
}

/** Returns the custom properties of the mesh and of its nodes. */
function propertiesOf({ glb: { json }, target }: FaceToImport): Record<string, unknown> {
  const owners: { name?: string | undefined; extras?: unknown }[] = [
    json.meshes![target.mesh],
    ...(json.nodes ?? []).filter(({ mesh }) => mesh === target.mesh),
  ]
  return Object.assign(
    {},
    ...owners.map(({ extras }) => (typeof extras === 'object' && extras !== null ? extras : {})),
  )
}

/** Returns one number per region, or undefined if the value is anything else. */
function numbersOf(value: unknown): number[] | undefined {
  const isValid =
    Array.isArray(value) &&
    value.length === REGIONS.length &&
    value.every((item) => typeof item === 'number' && Number.isFinite(item) && item >= 0)
  return isValid ? value : undefined
}
