import type { ReadonlySignal, Signal } from '@preact/signals'
import { smoothstep } from 'furrow/internal'
import { reducedMotion } from '../../motion.ts'
import type { Hovered } from '../hovered.ts'
import type { Viewer } from '../viewer.ts'
import { interpolateNumbers, interpolateRotations } from './interpolate.ts'
import { poseOfTarget } from './performance.ts'
import { type Pose, poseOf, writePose } from './pose.ts'

/** Time that the pointer must stay on a control before the preview starts, milliseconds. */
const DELAY = 150
/** Duration of the transition to a preview, and of the transition back, seconds. */
const TIME = 0.35

export interface PerformerParts {
  viewer: ReadonlySignal<Viewer | null>
  /** Set to true during a preview, to light the face from the side. */
  isSideLit: Signal<boolean>
  /** Called after the pose changed, so that a frame is drawn. */
  onPose(): void
}

/** Previews an area or a blendshape on the face while the pointer is on its control. Afterwards, restores the pose. */
export class Performer {
  readonly #parts: PerformerParts
  #timer = 0
  /** Pose before the preview. */
  #before: Pose | null = null
  #transition: { from: Pose; to: Pose; elapsed: number; isRelaxing: boolean } | null = null

  constructor(parts: PerformerParts) {
    this.#parts = parts
  }

  get isMoving(): boolean {
    return this.#transition !== null
  }

  /** Whether the face shows a preview, or moves to or from one. */
  get isPerforming(): boolean {
    return this.#before !== null
  }

  /** Starts a preview after a delay. Null ends the preview. */
  request(shown: Hovered | null): void {
    clearTimeout(this.#timer)
    if (!shown) this.#relax()
    else this.#timer = window.setTimeout(() => this.#perform(shown), DELAY)
  }

  /** Ends the preview immediately. Call before other code moves the face or reads its pose. */
  settle(): void {
    clearTimeout(this.#timer)
    const viewer = this.#parts.viewer.peek()
    if (viewer && this.#before) writePose(viewer, this.#before)
    this.#end()
  }

  /** @param delta seconds since the last frame. */
  advance(delta: number): void {
    const viewer = this.#parts.viewer.peek()
    if (!viewer || !this.#transition) return
    const { from, to, isRelaxing } = this.#transition
    this.#transition.elapsed += delta
    const t = Math.min(1, this.#transition.elapsed / TIME)
    const eased = smoothstep(t)
    writePose(viewer, {
      targets: interpolateNumbers(from.targets, to.targets, eased),
      areas: interpolateNumbers(from.areas, to.areas, eased),
      joints: interpolateRotations(from.joints, to.joints, eased),
    })
    if (t === 1) {
      this.#transition = null
      if (isRelaxing) this.#end()
    }
    this.#parts.onPose()
  }

  #perform({ kind, name }: Hovered): void {
    const viewer = this.#parts.viewer.peek()
    const performance = kind === 'shape' ? poseOfTarget(name) : viewer?.performanceOf(name)
    if (!viewer || !performance) {
      this.#relax()
      return
    }
    viewer.advance(Number.POSITIVE_INFINITY)
    this.#before ??= poseOf(viewer)
    this.#parts.isSideLit.value = true
    const targets = new Map(viewer.targets.map(({ name }) => [name, performance.targets.get(name) ?? 0]))
    const joints = new Map([...this.#before.joints, ...(performance.joints ?? [])])
    this.#moveTo(viewer, { targets, areas: performance.activations, joints }, false)
  }

  #relax(): void {
    const viewer = this.#parts.viewer.peek()
    if (!viewer || !this.#before) return
    this.#parts.isSideLit.value = false
    this.#moveTo(viewer, this.#before, true)
  }

  #moveTo(viewer: Viewer, to: Pose, isRelaxing: boolean): void {
    const elapsed = reducedMotion.matches ? TIME : 0
    this.#transition = { from: poseOf(viewer), to, elapsed, isRelaxing }
    this.#parts.onPose()
  }

  #end(): void {
    this.#before = null
    this.#transition = null
    this.#parts.isSideLit.value = false
  }
}
