import { BENT, type JointRotation, smoothstep } from 'furrow/internal'
import { type Object3D, Quaternion, type SkinnedMesh } from 'three'
import { fileName } from '../../open/rest-skeleton.ts'
import type { BodyPose } from './body-poses.ts'
import { interpolateNumbers, interpolateRotations, type JointRotations, type Numbers } from './interpolate.ts'

/** Name of the pose in which no joint is turned. */
export const REST_POSE = 'rest'

/** Joint that can be turned. */
export interface PosableJoint {
  /** Name in the file. */
  readonly name: string
  readonly bone: Object3D
  /** Rotation at rest, relative to the parent. */
  readonly rest: Quaternion
}

/** Rotations of all joints, and the amounts of poses that they contain. */
interface Turned {
  rotations: JointRotations
  amounts: Numbers
}

interface Transition {
  from: Turned
  to: Turned
  elapsed: number
  seconds: number
}

/**
 * Poses the joints of an avatar. Each pose has an amount, and a joint can be turned by hand in addition. The bones hold the result, because clips
 * and the user turn them too.
 */
export class SkeletonPose {
  readonly joints: readonly PosableJoint[]
  #poses: readonly BodyPose[] = []
  #amounts: Numbers = new Map()
  #transition: Transition | null = null

  /** @param rest rotations of all objects at rest. */
  constructor(root: Object3D, rest: ReadonlyMap<Object3D, Quaternion>) {
    this.joints = bonesOf(root).map((bone) => {
      return { name: fileName(bone), bone, rest: rest.get(bone) ?? bone.quaternion.clone() }
    })
  }

  get poses(): readonly BodyPose[] {
    return this.#poses
  }

  set poses(poses: readonly BodyPose[]) {
    this.#poses = poses
    const names = poses.map(({ name }) => name)
    this.#amounts = new Map([...this.#amounts].filter(([name]) => names.includes(name)))
  }

  get isMoving(): boolean {
    return this.#transition !== null
  }

  /** Whether any joint is turned. */
  get isTurned(): boolean {
    return this.joints.some(({ bone, rest }) => !bone.quaternion.equals(rest))
  }

  /** Amounts of the poses, 0..1. Does not move joints when it is set. */
  get amounts(): Numbers {
    return this.#amounts
  }

  set amounts(amounts: Numbers) {
    this.#amounts = amounts
  }

  /** Amount of a pose, 0..1. */
  amountOf(pose: string): number {
    return this.#amounts.get(pose) ?? 0
  }

  /** Changes the amount of a pose. Joints that were turned otherwise stay turned. */
  setAmount(pose: string, amount: number): void {
    const before = this.#turnsAt(this.#amounts)
    this.#amounts = new Map([...this.#amounts, [pose, amount]])
    const after = this.#turnsAt(this.#amounts)
    for (const { name, bone } of this.joints) {
      const [old, next] = [before.get(name), after.get(name)]
      if (!old && !next) continue
      if (old) bone.quaternion.multiply(old.invert())
      if (next) bone.quaternion.multiply(next)
      bone.quaternion.normalize()
    }
  }

  /** Starts a transition to a pose from the current one. @param pose name of a pose, or `REST_POSE`. */
  play(pose: string, seconds: number): void {
    const amounts = new Map(pose === REST_POSE ? [] : [[pose, BENT]])
    const turns = this.#turnsAt(amounts)
    const rotations = this.joints.map(({ name, rest }): [string, Quaternion] => {
      const turn = turns.get(name)
      return [name, turn ? rest.clone().multiply(turn) : rest]
    })
    const from = { rotations: this.read(), amounts: this.#amounts }
    const faded = [...this.#amounts.keys()].map((name): [string, number] => [name, 0])
    const to = { rotations: new Map(rotations), amounts: new Map([...faded, ...amounts]) }
    this.#transition = { from, to, elapsed: 0, seconds }
    if (seconds === 0) this.advance(0)
  }

  /** @param delta seconds since the last frame; infinity ends the transition. */
  advance(delta: number): void {
    const { from, to, seconds } = this.#transition ?? {}
    if (!from || !to || seconds === undefined) return
    this.#transition!.elapsed += delta
    const t = seconds > 0 ? Math.min(1, this.#transition!.elapsed / seconds) : 1
    const eased = smoothstep(t)
    this.write(interpolateRotations(from.rotations, to.rotations, eased))
    this.#amounts = interpolateNumbers(from.amounts, to.amounts, eased)
    if (t === 1) this.#transition = null
  }

  /** Returns the rotations of all joints. */
  read(): JointRotations {
    return new Map(this.joints.map(({ name, bone }) => [name, bone.quaternion.clone()]))
  }

  write(rotations: JointRotations): void {
    for (const { name, bone } of this.joints) {
      const rotation = rotations.get(name)
      if (rotation) bone.quaternion.copy(rotation)
    }
  }

  /** Returns the rotations of joints that are turned from their rest pose. */
  turned(turns: ReadonlyMap<string, JointRotation>): JointRotations {
    const own = this.joints.filter(({ name }) => turns.has(name))
    return new Map(
      own.map(({ name, rest }) => [name, rest.clone().multiply(new Quaternion(...turns.get(name)!))]),
    )
  }

  /** Returns the turn of each joint for amounts of poses, relative to rest. */
  #turnsAt(amounts: Numbers): Map<string, Quaternion> {
    const turns = new Map<string, Quaternion>()
    for (const { name: pose, joints } of this.#poses) {
      const amount = amounts.get(pose) ?? 0
      if (amount === 0) continue
      for (const [name, full] of joints) {
        const turn = new Quaternion().slerp(new Quaternion(...full), amount)
        turns.set(name, turns.get(name)?.multiply(turn) ?? turn)
      }
    }
    return turns
  }
}

/** Returns the bones of all skinned meshes, parents first. */
function bonesOf(root: Object3D): Object3D[] {
  const used = new Set<Object3D>()
  root.traverse((object) => {
    for (const bone of (object as Partial<SkinnedMesh>).skeleton?.bones ?? []) used.add(bone)
  })
  const bones: Object3D[] = []
  root.traverse((object) => {
    if (used.has(object)) bones.push(object)
  })
  return bones
}
