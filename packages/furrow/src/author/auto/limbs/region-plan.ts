import type { SkinRegion } from '../anatomy/region.ts'
import type { RegionCreases } from '../lines/crease.ts'
import type { LaidLine } from '../lines/laid-line.ts'
import type { JointTurn } from './turn.ts'

/** How the activation of an area follows the angle of a joint. */
export interface JointLink {
  turn: JointTurn
  /** Activation at rest, 0..1. Flexion creases of the hand are folds that never vanish. */
  rest: number
  /** Activation at the full angle, 0..1. Less than `rest` for skin that the turn stretches. */
  full: number
  /** Fraction of the full angle up to which the surface does not fold, because it has slack; default: 0. */
  slack?: number
}

/** Part of a limb with its own area of influence, before its lines are laid. */
export interface RegionPlan extends Omit<SkinRegion, 'cause'> {
  /** Turn that compresses the skin. */
  turn: JointTurn
  /** Standard deviation, in millimetres, of the diffusion of skin weights: half the radius of the limb. */
  looseness: number
  /**
   * Returns the weight of all turned joints at a point, 0..1. Default: each joint has its own skin weights, diffused over `looseness`, with
   * everything below it.
   */
  moved?: (point: number) => number
  /** Fraction of the full angle at which the strain is measured; default: 1. */
  strained?: number
  /** Links to joints. The activations of several links add up. */
  links: readonly JointLink[]
  /** Name that the same region has on the other side of the body; undefined if there is none. */
  pair?: string
  /** Importance: regions with a lower one are dropped first if there are too many areas. */
  rank: number
  /**
   * Lays the lines and converts them to strokes.
   *
   * @param tensors result of `turnTensors` at the full angle.
   * @returns undefined if there are none.
   */
  crease(tensors: Float64Array): RegionCreases | undefined
}

/** Part of skin, before its lines are laid and converted to strokes. */
export interface SkinPlan extends Omit<RegionPlan, 'crease'> {
  /**
   * Lays the lines.
   *
   * @param tensors result of `turnTensors` at the full angle.
   */
  lay(tensors: Float64Array): LaidLine[]
}
