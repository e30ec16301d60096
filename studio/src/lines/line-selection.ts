import { computed, effect, type ReadonlySignal, signal } from '@preact/signals'
import { type Fork, findForks } from 'furrow/internal'
import type { LayerStroke } from '../document/document.ts'
import type { Session } from '../session/session.ts'
import { type Handle, handlesOf } from './handles.ts'
import type { LineSurface } from './line-surface.ts'

/** Stores which wrinkle lines are chosen, and which point of the main one. The main line is the last that the user chose. */
export class LineSelection {
  /** Index of the chosen point in `handles`, or -1. */
  readonly point = signal(-1)
  readonly #session: Session
  readonly #surface: () => LineSurface | null
  /** Indices of the chosen lines, first the main one. They stay valid when an operation or undo replaces the objects of the lines. */
  readonly #indices = signal<readonly number[]>([])

  /** Chosen lines, first the main one. */
  readonly all: ReadonlySignal<readonly LayerStroke[]> = computed(() => {
    const strokes = this.#session.document.value?.strokes ?? []
    return this.#indices.value.flatMap((index) => strokes[index] ?? [])
  })

  readonly main: ReadonlySignal<LayerStroke | null> = computed(() => this.all.value[0] ?? null)

  /** Forks of all lines. */
  readonly forks: ReadonlySignal<readonly Fork[]> = computed(() => {
    const [document, surface] = [this.#session.document.value, this.#surface()]
    return document && surface ? findForks(document.strokes, surface.lines) : []
  })

  /** Points of the main line, and forks on it, from its start to its end. */
  readonly handles: ReadonlySignal<readonly Handle[]> = computed(() => {
    const line = this.main.value && this.#surface()?.lines.lineOf(this.main.value)
    return line ? handlesOf(this.#indices.value[0], line, this.forks.value) : []
  })

  /** @param surface returns the skin of the current face, or null if there is no document. */
  constructor(session: Session, surface: () => LineSurface | null) {
    this.#session = session
    this.#surface = surface
    // New automatic wrinkles replace lines, so the indices of the chosen lines would mean other lines.
    const auto = computed(() => session.document.value?.auto)
    effect(() => {
      auto.value
      this.chooseIndices([])
    })
  }

  /** Indices of the chosen lines in the document, first the main one. */
  get indices(): readonly number[] {
    const count = this.#session.document.peek()?.strokes.length ?? 0
    return this.#indices.peek().filter((index) => index < count)
  }

  /** Index of the main line in the document, or -1. */
  get index(): number {
    return this.indices[0] ?? -1
  }

  /** Handle of the chosen point, or undefined. */
  get handle(): Handle | undefined {
    return this.handles.peek()[this.point.peek()]
  }

  choose(stroke: LayerStroke | null): void {
    const index = this.#indexOf(stroke)
    this.chooseIndices(index < 0 ? [] : [index])
  }

  chooseIndices(indices: readonly number[]): void {
    this.#indices.value = indices
    this.point.value = -1
  }

  /** Adds a line to the chosen lines, as the main one. If it is already chosen, removes it from them. */
  toggle(stroke: LayerStroke): void {
    const index = this.#indexOf(stroke)
    if (index < 0) return
    const others = this.indices.filter((each) => each !== index)
    this.chooseIndices(others.length < this.indices.length ? others : [index, ...others])
  }

  /** Chooses all lines with the group of the main line, which stays the main one. */
  chooseGroup(): void {
    const [strokes, main] = [this.#session.document.peek()?.strokes ?? [], this.index]
    const group = strokes[main]?.group
    if (group === undefined) return
    const others = [...strokes.keys()].filter((index) => index !== main && strokes[index].group === group)
    this.chooseIndices([main, ...others])
  }

  /** Makes a chosen line the main one. */
  makeMain(stroke: LayerStroke): void {
    const index = this.#indexOf(stroke)
    this.chooseIndices([index, ...this.indices.filter((each) => each !== index)])
  }

  /** Chooses a fork and a line at it: the fork's trunk, or a line that ends at the fork if there is no trunk. */
  chooseFork(fork: Fork): void {
    const [{ stroke }] = [...fork.trunks, ...fork.ends]
    this.chooseIndices([stroke])
    this.point.value = this.handles.peek().findIndex((handle) => handle.fork === fork)
  }

  /** Returns the ends of a line that are in forks. 0: its start, 1: its end. @param index index of the line in the document. */
  attachedEnds(index: number): (0 | 1)[] {
    return this.forks
      .peek()
      .flatMap(({ ends }) => ends.flatMap(({ stroke, end }) => (stroke === index ? end : [])))
  }

  #indexOf(stroke: LayerStroke | null): number {
    return (stroke && this.#session.document.peek()?.strokes.indexOf(stroke)) ?? -1
  }
}
