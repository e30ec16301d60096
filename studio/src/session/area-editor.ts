import { batch, computed, effect, type ReadonlySignal, type Signal, signal } from '@preact/signals'
import type { AreaConvention, GrayImage } from 'furrow'
import { resampleGray } from 'furrow/internal'
import { setAreaSize } from '../document/area-size.ts'
import {
  type AreaFields,
  addArea,
  addEmptyArea,
  duplicateArea,
  emptyArea,
  mirrorArea,
  mirroredName,
  paintArea,
  removeArea,
  renameArea,
  setArea,
} from '../document/areas.ts'
import type { StudioArea, StudioDocument } from '../document/document.ts'
import { recordPose } from '../document/drivers.ts'
import { freeName } from '../document/names.ts'
import {
  fillFromImageStep,
  recordPoseStep,
  regionStep,
  resizeRegionsStep,
  STEP,
  showInPoseStep,
} from '../labels/steps.ts'
import type { Session } from './session.ts'

type Names = ReadonlySet<string>

/** Edits the document's areas of influence. Also stores which areas are chosen, muted and soloed. The document does not contain this state. */
export class AreaEditor {
  readonly #session: Session
  readonly #attempt: (task: () => void) => unknown
  readonly #chosen = signal<string | null>(null)
  readonly #muted = signal<Names>(new Set())
  readonly #soloed = signal<Names>(new Set())
  readonly #added = signal<readonly string[]>([])
  #lastHidden: readonly string[] = []

  /** Whether imported images of areas are white where there are no wrinkles (the convention `paper`). */
  readonly isPaper = signal(true)

  /** Convention of imported images of areas. */
  get convention(): AreaConvention {
    return this.isPaper.peek() ? 'paper' : 'weight'
  }

  /** Area whose controls are shown. */
  readonly chosen: ReadonlySignal<StudioArea | null> = computed(() => {
    return this.#session.document.value?.areas.find(({ name }) => name === this.#chosen.value) ?? null
  })

  /**
   * Names of the areas that the face shows as inactive: muted areas and, if any area is soloed, all areas that are not soloed. The
   * array is replaced only when the names change, because a new array causes a redraw of the face.
   */
  readonly hidden: ReadonlySignal<readonly string[]> = computed(() => {
    const [muted, soloed] = [this.#muted.value, this.#soloed.value]
    const names = this.#session.document.value?.areas.map(({ name }) => name) ?? []
    const hasSolo = names.some((name) => soloed.has(name))
    const hidden = names.filter((name) => muted.has(name) || (hasSolo && !soloed.has(name)))
    const last = this.#lastHidden
    const isSame = hidden.length === last.length && hidden.every((name, i) => name === last[i])
    if (!isSame) this.#lastHidden = hidden
    return this.#lastHidden
  })

  /** Areas that brushes have added on bare skin. The user has not chosen yet when they show. */
  readonly added: ReadonlySignal<readonly string[]> = computed(() => {
    const names = this.#session.document.value?.areas.map(({ name }) => name) ?? []
    return this.#added.value.filter((name) => names.includes(name))
  })

  get hasDocument(): boolean {
    return this.#session.document.peek() !== null
  }

  /** @param attempt runs a task and shows its error. */
  constructor(session: Session, attempt: (task: () => void) => unknown) {
    this.#session = session
    this.#attempt = attempt
    effect(() => {
      if (session.document.value === null) this.#forget()
    })
  }

  get muted(): ReadonlySignal<Names> {
    return this.#muted
  }

  get soloed(): ReadonlySignal<Names> {
    return this.#soloed
  }

  choose(name: string | null): void {
    this.#chosen.value = name
  }

  toggleMute(name: string): void {
    this.#muted.value = toggled(this.#muted.peek(), name)
  }

  toggleSolo(name: string): void {
    this.#soloed.value = toggled(this.#soloed.peek(), name)
  }

  /** Starts the question when an area shows that a brush has added. */
  askWhen(name: string): void {
    this.#added.value = [...this.#added.peek(), name]
  }

  /** Ends the question when the added areas show. */
  forgetAdded(): void {
    this.#added.value = []
  }

  addEmpty(): void {
    const name = freeName(this.#areas, 'area')
    this.#edit(STEP.addRegion, (document) => addEmptyArea(document, name))
    this.#chooseExisting(name)
  }

  /** Adds an area to the first layer, resamples its weights, and chooses it. */
  add({ name, weights }: { name: string; weights: GrayImage }): void {
    this.#edit(regionStep('Add', name), (document) =>
      addArea(document, { ...emptyArea(document, name), weights: resampleGray(weights, document.areaSize) }),
    )
    this.#chooseExisting(name)
  }

  /**
   * Replaces the weights of an area and chooses it. Adds it if it is new. Calls are one undo step until `settle`.
   *
   * @param area area as it was before it was painted.
   */
  paint(area: StudioArea, weights: GrayImage): void {
    const isNew = !this.#areas.some(({ name }) => name === area.name)
    this.#edit(
      regionStep('Paint', area.name),
      (old) => (isNew ? addArea(old, { ...area, weights }) : paintArea(old, area.name, weights)),
      `paint ${area.name}`,
    )
    this.#chooseExisting(area.name)
    if (isNew) this.askWhen(area.name)
  }

  duplicate(name: string): void {
    const copy = freeName(this.#areas, name)
    this.#edit(regionStep('Duplicate', name), (document) => duplicateArea(document, name))
    this.#chooseExisting(copy)
  }

  /**
   * Mirrors an area to the other side of the face and chooses the mirrored area.
   *
   * @param mirror returns mirrored weights.
   */
  mirror(name: string, mirror: (weights: GrayImage) => GrayImage): void {
    const document = this.#session.document.peek()
    const area = document?.areas.find((each) => each.name === name)
    if (!document || !area) return
    const other = mirroredName(document, name)
    this.#edit(regionStep('Mirror', name), (old) => mirrorArea(old, name, mirror(area.weights)))
    this.#chooseExisting(other)
  }

  /** Replaces the weights of an area by an image, after resampling the image to the size of the areas. */
  fill(name: string, weights: GrayImage): void {
    this.#edit(fillFromImageStep(name), (document) =>
      paintArea(document, name, resampleGray(weights, document.areaSize)),
    )
  }

  /** Resamples all areas to another width and height, texels, in one undo step. */
  resize(size: number): void {
    this.#edit(resizeRegionsStep(size), (document) => setAreaSize(document, size))
  }

  remove(name: string): void {
    this.#edit(regionStep('Remove', name), (document) => removeArea(document, name))
  }

  rename(name: string, newName: string): void {
    const follow = (names: Signal<Names>) => {
      if (names.peek().has(name)) names.value = new Set([...names.peek(), newName])
    }
    this.#attempt(() =>
      // Batch the changes. Otherwise, the chosen area would not exist between the first and the last change.
      batch(() => {
        this.#session.edit(regionStep('Rename', name), (document) => renameArea(document, name, newName))
        follow(this.#muted)
        follow(this.#soloed)
        if (this.#chosen.peek() === name) this.#chosen.value = newName
      }),
    )
  }

  set(name: string, fields: AreaFields): void {
    const key = `${Object.keys(fields).join()} of ${name}`
    this.#edit(regionStep('Change', name), (document) => setArea(document, name, fields), key)
  }

  /** Ends the undo step of consecutive calls of `set`. */
  settle(): void {
    this.#session.settle()
  }

  /** Makes a pose activate an area. @param weights blendshape weights by name, 0..1. */
  recordPose(name: string, weights: ReadonlyMap<string, number>): void {
    this.#edit(recordPoseStep(name), (document) => recordPose(document, name, weights))
  }

  /** Makes only a pose activate areas, which have been visible always. @param weights blendshape weights by name, 0..1. */
  showInPose(names: readonly string[], weights: ReadonlyMap<string, number>): void {
    this.#edit(showInPoseStep(names), (document) =>
      names.reduce((old, name) => setArea(recordPose(old, name, weights), name, { activation: 0 }), document),
    )
  }

  get #areas(): readonly StudioArea[] {
    return this.#session.document.peek()?.areas ?? []
  }

  #edit(label: string, operation: (document: StudioDocument) => StudioDocument, key?: string): void {
    this.#attempt(() => this.#session.edit(label, operation, key))
  }

  #chooseExisting(name: string): void {
    if (this.#areas.some((area) => area.name === name)) this.choose(name)
  }

  #forget(): void {
    this.#chosen.value = null
    this.#muted.value = new Set()
    this.#soloed.value = new Set()
    this.#added.value = []
  }
}

function toggled(names: Names, name: string): Names {
  return names.has(name) ? new Set([...names].filter((each) => each !== name)) : new Set([...names, name])
}
