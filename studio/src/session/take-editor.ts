import { computed, effect, type ReadonlySignal } from '@preact/signals'
import type { AnimationClip, Object3D } from 'three'
import type { Capture } from '../capture/live-link-face.ts'
import { takeClip } from '../capture/take-clip.ts'
import { rangeOf, type Take, type TakeMotion } from '../document/take.ts'
import { addTake, removeTake, renameTake, trimTake } from '../document/takes.ts'
import { STEP } from '../labels/steps.ts'
import type { Clip, ClipPlayer } from '../viewer/pose/clip-player.ts'
import type { Viewer } from '../viewer/viewer.ts'
import type { Session } from './session.ts'

/** Name of the first recorded take. Later ones get the next free number. */
const FIRST_NAME = 'Take 1'

export interface TakeEditorParts {
  session: Session
  player: ClipPlayer
  viewer: ReadonlySignal<Viewer | null>
  /** Resolves when the face has a document, because takes belong to it. */
  ready(): Promise<void>
  saveFile(file: Blob, name: string): void
  attempt(task: () => unknown): unknown
}

/** Edits the takes of the document, and passes them to the player. */
export class TakeEditor {
  readonly #parts: TakeEditorParts
  readonly #animations = new WeakMap<TakeMotion, { root: Object3D; animation: AnimationClip }>()

  constructor(parts: TakeEditorParts) {
    this.#parts = parts
    const { session, player, viewer } = parts
    const takes = computed(() => session.document.value?.takes)
    effect(() => {
      const root = viewer.value?.avatar.root
      player.setTakes(root ? (takes.value ?? []).map((take) => this.#clipOf(take, root)) : [])
    })
  }

  /** Take that the player has chosen, or null. */
  readonly chosen: ReadonlySignal<Take | null> = computed(() => {
    const { session, player } = this.#parts
    const index = player.takes.value.indexOf(player.clip.value!)
    return session.document.value?.takes?.[index] ?? null
  })

  /** Adds and chooses a recorded take. */
  add(motion: TakeMotion): void {
    void this.#parts.attempt(() => this.#add(STEP.recordTake, { name: FIRST_NAME, motion }))
  }

  /** Adds and chooses a take from a file. Rejects with a FurrowError if the face has none of its blendshapes. */
  async open(capture: Capture): Promise<void> {
    const { takeOfCapture } = await import('../capture/take-of-capture.ts')
    await this.#add(STEP.openRecording, takeOfCapture(capture, this.#targets))
  }

  rename(name: string, next: string): void {
    void this.#parts.attempt(() =>
      this.#parts.session.edit(STEP.renameTake, (document) => renameTake(document, name, next)),
    )
  }

  /** Sets the in and out points, seconds. */
  trim(name: string, range: readonly [number, number]): void {
    this.#parts.session.edit(STEP.trimTake, (document) => trimTake(document, name, range))
  }

  /** Moves the in or the out point of the chosen take to the time of the player. */
  trimAtTime(point: 'in' | 'out'): void {
    const take = this.chosen.peek()
    if (!take) return
    const [start, end] = rangeOf(take)
    const time = this.#parts.player.time.peek()
    this.trim(take.name, point === 'in' ? [time, Math.max(end, time)] : [Math.min(start, time), time])
  }

  remove(name: string): void {
    this.#parts.session.edit(STEP.deleteTake, (document) => removeTake(document, name))
  }

  /** Saves a take as a CSV of Live Link Face. Rejects if the code cannot be loaded. */
  async save(take: Take): Promise<void> {
    const { takeCsv } = await import('../capture/take-csv.ts')
    const name = take.name.replace(/[\\/:*?"<>|\p{Cc}]/gu, '_')
    this.#parts.saveFile(new Blob(takeCsv(take), { type: 'text/csv' }), `${name}.csv`)
  }

  async #add(label: string, take: Take): Promise<void> {
    const { session, player, ready } = this.#parts
    await ready()
    session.edit(label, (document) => addTake(document, take))
    const added = player.takes.peek().at(-1)
    if (added && session.document.peek()?.takes?.at(-1)?.motion === take.motion) player.choose(added)
  }

  get #targets(): readonly string[] {
    return this.#parts.viewer.peek()?.targets.map(({ name }) => name) ?? []
  }

  #clipOf(take: Take, root: Object3D): Clip {
    const known = this.#animations.get(take.motion)
    const animation = known?.root === root ? known.animation : takeClip(take.motion, root)
    this.#animations.set(take.motion, { root, animation })
    return { name: take.name, animation, range: rangeOf(take) }
  }
}
