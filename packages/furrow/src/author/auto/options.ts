import { FurrowError } from '../../core/error.ts'
import { MAX_IMAGE_SIDE, MAX_LAYERS } from '../../core/limits.ts'
import { checkOptionNames, didYouMean } from '../../core/nearest-name.ts'
import type { TangentFrame } from '../normals/height-to-normal.ts'
import {
  AUTO_REGIONS,
  AUTO_SIDES,
  type AutoRegion,
  type AutoSide,
  DENSE_REGIONS,
  type DenseRegion,
} from './anatomy/region-names.ts'
import { CLOTH_KINDS, type ClothKind } from './cloth/cloth-kinds.ts'

/** Options of `autoWrinkles`; `AUTO_DEFAULTS` has the constant defaults. */
export interface AutoOptions {
  /**
   * Age in years, 20..80. With age, lines grow in number, length and depth. If the option is given, the neutral face also shows lines of this
   * age until the application sets the input `age`. If it is over 35, the face also gets bulges, such as bags under the eyes.
   */
  age?: number
  /** Factor on the depth of all wrinkles, 0..2. */
  strength?: number
  /** Width and height of the layers' maps in texels. Maps of cloth are smaller if that suffices for its wide folds. */
  size?: number
  /** Width and height of the areas' maps in texels. Default: 128; up to 512 if joints fold small parts of a large skin. */
  areaSize?: number
  /** Random seed, an integer. The same seed produces the same wrinkles. Default: derived from the proportions of the face. */
  seed?: number
  /** Seeds that replace `seed` in single regions. The seed of `foreheadInner` applies to the whole forehead. */
  seeds?: Readonly<Partial<Record<AutoRegion, number>>>
  /**
   * Factors on the depth in single regions, 0..2, in addition to `strength`. The keys are regions, or halves of regions such as
   * `crowsFeetLeft`, which take precedence. Between the regions of the forehead, which share lines, the depth changes smoothly.
   */
  strengths?: Readonly<Partial<Record<AutoSide, number>>>
  /** Factors on the number of lines in single regions, 0.5..2. The factor of `foreheadInner` applies to the whole forehead. */
  densities?: Readonly<Partial<Record<DenseRegion, number>>>
  /**
   * How much the right side of a face mirrors the left side, 0..1. At 0, the sides differ as in people. At 1, the lines of a symmetric face are
   * symmetric.
   */
  symmetry?: number
  /** Maximum number of layers, 1..4. Fine furrows require at least 2. */
  layers?: number
  /** Maximum number of areas with wrinkle lines, 1..64. If more regions crease, those whose skin is compressed least are dropped. */
  areas?: number
  /** Regions of the face that get wrinkles; default: all. The option requires that a face is detected. */
  regions?: readonly AutoRegion[]
  /** Whether to add a layer with a pattern of fine furrows to a face. Furrows narrower than two texels are skipped. */
  furrows?: boolean
  /** Kind of cloth, if the surface is cloth. Joints then fold it, and blendshapes do not. Default: the surface is skin. */
  cloth?: ClothKind
  /**
   * Whether the joints of chains fold the surface, such as those of a tail or a tentacle, if the skeleton is not a humanoid. Default: false,
   * because skin of animals has fur.
   */
  tubes?: boolean
  /** Tangent frame of the normal maps; see `TangentFrame`. */
  frame?: TangentFrame
}

/** Defaults of `AutoOptions` that do not depend on the face. */
export const AUTO_DEFAULTS = {
  age: 45,
  strength: 1,
  size: 1024,
  areaSize: 128,
  seeds: {},
  strengths: {},
  densities: {},
  symmetry: 0,
  layers: 4,
  areas: 24,
  regions: AUTO_REGIONS,
  furrows: false,
  tubes: false,
  frame: 'orthonormal',
} as const satisfies AutoOptions

/** Minimum and maximum of each numeric option. */
const RANGES = {
  age: [20, 80],
  strength: [0, 2],
  size: [1, MAX_IMAGE_SIDE],
  areaSize: [2, MAX_IMAGE_SIDE],
  seed: [0, 2 ** 31 - 1],
  symmetry: [0, 1],
  layers: [1, MAX_LAYERS],
  areas: [1, 64],
} as const satisfies Partial<Record<keyof AutoOptions, readonly [number, number]>>

/** Options that need not be integers. */
const FRACTIONS: readonly string[] = ['age', 'strength', 'symmetry', 'density']

/** Options with a value for each of several regions: name of a value, allowed keys, minimum and maximum. */
const BY_REGION = {
  seeds: ['seed', AUTO_REGIONS, RANGES.seed],
  strengths: ['strength', AUTO_SIDES, RANGES.strength],
  densities: ['density', DENSE_REGIONS, [0.5, 2]],
} as const satisfies Partial<Record<keyof AutoOptions, readonly unknown[]>>

/**
 * Checks the options of `autoWrinkles`.
 *
 * @param who name of the caller in errors.
 * @param others names of options that the caller checks.
 * @throws FurrowError for the first option that is unknown or out of range.
 */
export function checkAutoOptions(options: AutoOptions, who: string, others: readonly string[] = []): void {
  checkOptionNames(options, [...Object.keys(AUTO_DEFAULTS), 'seed', 'cloth', ...others], who)
  for (const [name, range] of Object.entries(RANGES)) {
    const value = options[name as keyof typeof RANGES]
    if (value !== undefined) checkNumber(value, name, range, who)
  }
  if (options.cloth !== undefined) checkName(options.cloth, CLOTH_KINDS, 'kind of cloth', who)
  for (const [option, [name, regions, range]] of Object.entries(BY_REGION)) {
    for (const [region, value] of Object.entries(options[option as keyof typeof BY_REGION] ?? {})) {
      checkName(region, regions, 'region', who)
      checkNumber(value, name, range, who)
    }
  }
  for (const region of options.regions ?? []) checkName(region, AUTO_REGIONS, 'region', who)
}

function checkNumber(
  value: unknown,
  name: string,
  [low, high]: readonly [number, number],
  who: string,
): void {
  const isFraction = FRACTIONS.includes(name)
  const isNumber = isFraction ? typeof value === 'number' : Number.isInteger(value)
  if (isNumber && (value as number) >= low && (value as number) <= high) return
  const kind = isFraction ? 'a number' : 'a whole number'
  throw new FurrowError({
    code: 'out-of-range',
    who,
    problem: `invalid ${name}`,
    value: value ?? String(value),
    limit: `${kind}, ${low} to ${high}`,
    remedy: 'correct the option',
  })
}

function checkName(name: string, allowed: readonly string[], what: string, who: string): void {
  if (allowed.includes(name)) return
  throw new FurrowError({
    code: 'unknown-name',
    who,
    problem: `unknown ${what}`,
    value: name,
    limit: allowed.join(', '),
    remedy: didYouMean(name, allowed, 'name one of them'),
  })
}
