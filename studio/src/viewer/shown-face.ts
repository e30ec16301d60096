import { type ReadonlySignal, type Signal, signal, untracked } from '@preact/signals'
import type { Messages } from '../messages.ts'
import { reducedMotion } from '../motion.ts'
import type { Hovered } from './hovered.ts'
import type { Orbit } from './orbit.ts'
import { ClipPlayer } from './pose/clip-player.ts'
import type { Dial } from './pose/dials.ts'
import { Performer } from './pose/performer.ts'
import { Staging } from './staging.ts'
import type { Viewer } from './viewer.ts'

/** Seconds of the transition from one expression to another. */
const EXPRESSION_TIME = 0.35

export interface ShownFaceParts {
  /** Null while another one is being opened. */
  live(): Viewer | null
  orbit(): Orbit | null
  messages: Messages
  /** Requests the next frame. */
  wake(): void
}

/** The face on the stage as the controls see and move it. */
export class ShownFace {
  /** Null before the first face is open. */
  readonly viewer = signal<Viewer | null>(null)
  readonly hovered: Signal<Hovered | null> = signal(null)
  readonly staging: Staging
  /** Key frames. */
  readonly player: ClipPlayer
  readonly #parts: ShownFaceParts
  readonly #performer: Performer
  readonly #frame = signal(0)
  readonly #revision = signal(0)
  readonly #expression = signal<string | null>(null)

  constructor(parts: ShownFaceParts) {
    this.#parts = parts
    const { viewer } = this
    this.staging = new Staging({ viewer, orbit: parts.orbit, wake: parts.wake })
    const onPose = () => {
      this.#frame.value++
      parts.wake()
    }
    this.#performer = new Performer({ viewer, isSideLit: this.staging.isSideLit, onPose })
    this.player = new ClipPlayer({
      viewer,
      begin: () => {
        this.#rest()
        this.#expression.value = null
      },
      onPose,
    })
  }

  /** Changes whenever a number on the face may have changed: a blendshape's weight, an activation. */
  get frame(): ReadonlySignal<number> {
    return this.#frame
  }

  /** Changes whenever the viewer's areas, mode or look have changed. */
  get revision(): ReadonlySignal<number> {
    return this.#revision
  }

  /** The expression that the face shows or moves to; null once a slider has changed it. */
  get expression(): ReadonlySignal<string | null> {
    return this.#expression
  }

  get moving(): boolean {
    return (this.#live?.moving || this.#performer.moving || this.player.isPlaying.peek()) ?? false
  }

  show(viewer: Viewer): void {
    const { root, animations } = viewer.avatar
    const isOther = root !== this.viewer.peek()?.avatar.root
    this.viewer.value = viewer
    if (!isOther) return
    this.#expression.value = null
    this.player.open(root, animations)
  }

  /** @param delta seconds since the last frame. */
  advance(delta: number): void {
    const viewer = this.#live
    const wasMoving = viewer?.moving
    viewer?.advance(delta)
    this.#performer.advance(delta)
    this.player.advance(delta)
    if (wasMoving) this.#frame.value++
  }

  /** Controls read everything again. */
  refresh(): void {
    this.#revision.value++
    this.#frame.value++
  }

  /** Changes the viewer; shows errors, and updates the controls to the state that results. */
  change(task: (viewer: Viewer) => void): void {
    const viewer = this.#live
    if (!viewer) return
    void this.#parts.messages
      .attempt(() => task(viewer))
      .then(() => {
        this.refresh()
        this.#parts.wake()
      })
  }

  /** Moves to an expression. */
  play(name: string): void {
    this.change((viewer) => {
      this.#performer.settle()
      this.player.stop()
      viewer.play(name, reducedMotion.matches ? 0 : EXPRESSION_TIME)
      this.#expression.value = name
      this.#frame.value++
    })
  }

  /** Moves a slider by hand. A clip goes on unless it is a blendshape's. */
  input(dial: Dial, value: number): void {
    if (this.#live?.targets.includes(dial)) this.set(() => dial.write(value))
    else this.#set(() => dial.write(value))
  }

  /** Sets another pose by hand: no clip moves the face then. */
  set(write: () => void): void {
    this.#set(() => {
      this.player.stop()
      write()
    })
  }

  /** Sets sliders after finishing the transition to an expression. */
  #set(write: () => void): void {
    this.change(() => {
      this.#rest()
      write()
      this.#expression.value = null
      this.#frame.value++
    })
  }

  reset(dials: readonly Dial[]): void {
    this.set(() => {
      for (const dial of dials) dial.write(0)
    })
  }

  /** Weights of the blendshapes, by the names on their dials. */
  pose(): Map<string, number> {
    this.settle()
    return new Map(this.#live?.targets.map((dial) => [dial.name, dial.read()]))
  }

  /** Lets the face show an area or a blendshape that is hovered. */
  perform(hovered: Hovered | null): void {
    const shown = hovered?.kind === 'target' || this.player.isPlaying.peek() ? null : hovered
    untracked(() => this.#performer.request(shown))
  }

  /** Ends a performance: the face has the pose before it. */
  settle(): void {
    this.#performer.settle()
  }

  /** Shows which areas the pointer or focus is on, or which ones the blendshape moves, or else the one that is painted. */
  highlight(painted: string | null): void {
    const [viewer, hovered] = [this.viewer.value, this.hovered.value]
    if (!viewer) return
    if (!hovered) viewer.highlight(painted === null ? [] : [painted])
    else if (hovered.kind === 'shape') viewer.highlight([])
    else if (hovered.kind === 'target') viewer.highlight(viewer.driven.drivenBy(hovered.name))
    // The face performs instead, where it can.
    else if (painted === null && viewer.performanceOf(hovered.name)) viewer.highlight([])
    else viewer.highlight([hovered.name])
    this.#parts.wake()
  }

  /** Ends what moves the face by itself, but for a clip. */
  #rest(): void {
    this.settle()
    this.#live?.advance(Number.POSITIVE_INFINITY)
  }

  get #live(): Viewer | null {
    return this.#parts.live()
  }
}
