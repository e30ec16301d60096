import type { ReadonlySignal, Signal } from '@preact/signals'
import { reducedMotion } from '../../motion.ts'
import type { Hovered } from '../hovered.ts'
import type { Viewer } from '../viewer.ts'
import type { Dial } from './dials.ts'
import { poseOfTarget } from './performance.ts'

/** Milliseconds from when something is pointed at until the face performs, and seconds that it takes to. */
const DELAY = 150
const TIME = 0.35

/** Numbers by the names of dials. */
type Numbers = ReadonlyMap<string, number>

interface Pose {
  targets: Numbers
  areas: Numbers
}

export interface PerformerParts {
  viewer: ReadonlySignal<Viewer | null>
  /** Set while the face performs. */
  isSideLit: Signal<boolean>
  /** The pose is another one, and a frame is to be drawn. */
  onPose(): void
}

/** Lets the face show what is pointed at: an area by its expression, or a blendshape. A preview: the pose before comes back. */
export class Performer {
  readonly #parts: PerformerParts
  #timer = 0
  /** Before the face began to perform. */
  #before: Pose | null = null
  #transition: { from: Pose; to: Pose; elapsed: number; isRelaxing: boolean } | null = null

  constructor(parts: PerformerParts) {
    this.#parts = parts
  }

  get moving(): boolean {
    return this.#transition !== null
  }

  /** Points at something; null at nothing. */
  request(shown: Hovered | null): void {
    clearTimeout(this.#timer)
    if (!shown) this.#relax()
    else this.#timer = window.setTimeout(() => this.#perform(shown), DELAY)
  }

  /** Ends the preview at once: before anything else moves the face, or reads its pose. */
  settle(): void {
    clearTimeout(this.#timer)
    const viewer = this.#parts.viewer.peek()
    if (viewer && this.#before) write(viewer, this.#before)
    this.#end()
  }

  /** @param delta seconds since the last frame. */
  advance(delta: number): void {
    const viewer = this.#parts.viewer.peek()
    if (!viewer || !this.#transition) return
    const { from, to, isRelaxing } = this.#transition
    this.#transition.elapsed += delta
    const t = Math.min(1, this.#transition.elapsed / TIME)
    const eased = t * t * (3 - 2 * t)
    write(viewer, {
      targets: between(from.targets, to.targets, eased),
      areas: between(from.areas, to.areas, eased),
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
    this.#moveTo(viewer, { targets, areas: performance.activations }, false)
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

function poseOf({ targets, areas }: Viewer): Pose {
  return { targets: numbersOf(targets), areas: numbersOf(areas) }
}

function numbersOf(dials: readonly Dial[]): Numbers {
  return new Map(dials.map(({ name, read }) => [name, read()]))
}

function between(from: Numbers, to: Numbers, t: number): Numbers {
  return new Map(
    [...to].map(([name, end]) => [name, t === 1 ? end : (from.get(name) ?? 0) * (1 - t) + end * t]),
  )
}

/** Blendshapes first: areas that were set by hand are not what these drive. */
function write({ targets, areas }: Viewer, pose: Pose): void {
  const writeAll = (dials: readonly Dial[], numbers: Numbers) => {
    for (const dial of dials) {
      const number = numbers.get(dial.name)
      if (number !== undefined && number !== dial.read()) dial.write(number)
    }
  }
  writeAll(targets, pose.targets)
  writeAll(areas, pose.areas)
}
