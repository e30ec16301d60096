import { computed, effect, type ReadonlySignal, signal } from '@preact/signals'
import { FurrowError, type GrayImage } from 'furrow'
import type { SkinCanvas, Uv } from 'furrow/author'
import { texelAt } from 'furrow/internal'
import type { StudioArea, StudioDocument } from '../document/document.ts'
import { fillWithLinesStep } from '../labels/steps.ts'
import type { AreaEditor } from '../session/area-editor.ts'
import type { Session } from '../session/session.ts'

/** Minimum weight of an area at a point of a line that is on it, 0..255. */
const ON_AREA = 32

export interface FillOfferParts {
  session: Session
  areas: Pick<AreaEditor, 'chosen'>
  /** Returns the skin of the current face, or null if it cannot be prepared. */
  canvas(): Promise<SkinCanvas | null>
  /** Called when a region has been filled. */
  onFilled(): void
  /** Runs a task and shows its errors. */
  attempt(task: () => unknown): unknown
}

/** Offers to fill a region with lines, after the user has painted it where its layer has none. */
export class FillOffer {
  readonly #parts: FillOfferParts
  readonly #painted = signal<string | null>(null)
  readonly #refused = new Set<string>()

  /** Name of the region that can be filled, or null. */
  readonly offered: ReadonlySignal<string | null> = computed(() => {
    const [document, area] = [this.#parts.session.document.value, this.#parts.areas.chosen.value]
    const isPainted = area !== null && area.name === this.#painted.value
    return document && isPainted && !isEmpty(area.weights) && !hasLines(document, area) ? area.name : null
  })

  constructor(parts: FillOfferParts) {
    this.#parts = parts
    effect(() => {
      if (parts.session.document.value) return
      this.#painted.value = null
      this.#refused.clear()
    })
  }

  /** Offers to fill a region, unless the user has refused before. */
  painted(area: string): void {
    if (!this.#refused.has(area)) this.#painted.value = area
  }

  refuse(): void {
    const area = this.#painted.peek()
    if (area !== null) this.#refused.add(area)
    this.#painted.value = null
  }

  /** Fills the region with lines, in one undo step; see `fillArea`. */
  fill(): void {
    const { session, canvas, onFilled, attempt } = this.#parts
    const name = this.offered.peek()
    if (name === null) return
    this.#painted.value = null
    void attempt(async () => {
      const [{ fillArea }, skin] = await Promise.all([import('./fill-area.ts'), canvas()])
      if (!skin) throw noSkinError(name)
      session.edit(fillWithLinesStep(name), (document) => fillArea(document, name, skin))
      onFilled()
    })
  }
}

function isEmpty({ data }: GrayImage): boolean {
  return data.every((weight) => weight < ON_AREA)
}

/** Whether a line of the area's layer lies on the area with at least half of its points. */
function hasLines({ strokes }: StudioDocument, { layer, weights }: StudioArea): boolean {
  const isOn = (uv: Uv) => texelAt(weights, uv) >= ON_AREA
  return strokes.some((stroke) => {
    return stroke.layer === layer && 2 * stroke.points.filter(isOn).length >= stroke.points.length
  })
}

function noSkinError(area: string): FurrowError {
  return new FurrowError({
    who: 'Studio',
    problem: `the skin is not ready to fill ${area} with lines`,
    remedy: 'paint again when the face is shown',
  })
}
