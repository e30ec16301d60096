import type { BodySide, Finger } from './bone-names.ts'

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

/** Parts of a humanoid that the skeleton of a skin moves. */
export interface Body {
  hands: readonly HandJoints[]
  neck: NeckJoints | undefined
}
