import type { BodySide, Finger, Hinge } from './bone-names.ts'

/** Joints of a hand that moves the skin. Values are indices into the skeleton's joints. */
export interface HandJoints {
  /** Undefined if the hand was recognised by the shape of its skeleton. */
  side: BodySide
  wrist: number
  /** Joints of each finger from its base to its tip, at most three. */
  fingers: ReadonlyMap<Finger, readonly number[]>
}

/** Joints of a neck. */
export interface NeckJoints {
  /** Joint below the neck. */
  base: number
  /** Joints from the first one of the neck to the head. */
  chain: readonly number[]
}

/** Joints of an arm or a leg that bends at a hinge. */
export interface HingedLimb {
  kind: Hinge
  side: BodySide
  /** First joint of the straight line of bones that ends at the hinge. */
  start: number
  hinge: number
  /** Joint at the end of the lower half: the hand or the foot; undefined if the skeleton has none. */
  end: number | undefined
}

/** Joints of the spine between the legs and the arms. */
export interface TrunkJoints {
  /** Joint at which the legs begin. */
  base: number
  /** Joints above `base`, up to the one at which the arms begin. */
  chain: readonly number[]
}

/** Parts of a humanoid that the skeleton of a skin moves. */
export interface Body {
  hands: readonly HandJoints[]
  neck: NeckJoints | undefined
  limbs: readonly HingedLimb[]
  trunk: TrunkJoints | undefined
}
