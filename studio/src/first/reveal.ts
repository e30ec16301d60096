import { smoothstep } from 'furrow/internal'
import { reducedMotion } from '../motion.ts'
import type { OpenedAvatar } from '../open/avatar.ts'
import type { ShownFace } from '../viewer/shown-face.ts'
import type { Viewer } from '../viewer/viewer.ts'
import { type RevealPlan, revealPlan } from './reveal-plan.ts'
import { hasSeen, remember } from './seen.ts'

/** Duration, seconds. */
const DURATION = 5
/** Duration after which the divider has crossed the face and returns to its middle, seconds. */
const SWEEP = 4

/** Maximum step, seconds. */
const MAX_STEP = 0.25

/** Inputs that end the performance. */
const INPUTS = ['pointerdown', 'keydown', 'wheel'] as const

export interface RevealParts {
  face: ShownFace
  /** @param position as a fraction of the stage's width. */
  moveDivider(position: number): void
  /** Called when the performance has ended, or at once where motion is reduced. */
  onEnd(): void
}

/** Lets a dropped avatar perform a few expressions, or poses of its joints, while the divider crosses it. Any input ends this. */
export class Reveal {
  readonly #parts: RevealParts
  /** Avatar that was dropped and has not performed yet. */
  #awaited: OpenedAvatar['root'] | null = null
  #running: (RevealPlan & { elapsed: number; last: number; step: number }) | null = null

  constructor(parts: RevealParts) {
    this.#parts = parts
    for (const name of INPUTS) addEventListener(name, () => this.stop(), { capture: true, passive: true })
  }

  get isMoving(): boolean {
    return this.#running !== null
  }

  /** Lets an avatar perform as soon as it has wrinkles, unless its file has performed before. */
  await({ root, files: [{ file }] }: OpenedAvatar): void {
    const key = `${file.name} ${file.size} ${file.lastModified}`
    this.#awaited = hasSeen(key) ? null : root
    remember(key)
  }

  /** Starts if the avatar is awaited and has wrinkles. */
  begin(viewer: Viewer): void {
    if (viewer.avatar.root !== this.#awaited || !viewer.wrinkles) return
    this.#awaited = null
    const plan = revealPlan(viewer)
    if (!plan || reducedMotion.matches) this.#parts.onEnd()
    else this.#running = { ...plan, elapsed: 0, last: performance.now(), step: -1 }
  }

  /** Moves on by the time since the last frame, up to `MAX_STEP`: the first frames of an avatar can take seconds. */
  advance(): void {
    const running = this.#running
    if (!running) return
    const now = performance.now()
    running.elapsed += Math.min((now - running.last) / 1000, MAX_STEP)
    running.last = now
    const { kind, plan, strongest, elapsed } = running
    const show = (name: string) =>
      kind === 'expression' ? this.#parts.face.play(name) : this.#parts.face.playPose(name)
    if (elapsed >= DURATION) {
      this.#end()
      show(strongest)
      return
    }
    const step = Math.floor((elapsed / DURATION) * plan.length)
    if (step !== running.step) show(plan[step])
    running.step = step
    this.#parts.moveDivider(dividerAt(elapsed))
  }

  stop(): void {
    if (this.#running) this.#end()
  }

  #end(): void {
    this.#running = null
    this.#parts.moveDivider(0.5)
    this.#parts.onEnd()
  }
}

/** Returns the position of the divider: from the right edge to the left one, and back to the middle. */
function dividerAt(elapsed: number): number {
  if (elapsed < SWEEP) return 1 - smoothstep(elapsed / SWEEP)
  return 0.5 * smoothstep((elapsed - SWEEP) / (DURATION - SWEEP))
}
