import { computed, effect, type ReadonlySignal, signal } from '@preact/signals'
import { FurrowError, type GrayImage } from 'furrow'
import type { SkinCanvas } from 'furrow/author'
import { hasLines, ON_AREA } from '../document/lines-on-area.ts'
import type { AreaEditor } from '../session/area-editor.ts'
import type { Session } from '../session/session.ts'

export interface FillOfferParts {
  session: Session
  areas: Pick<AreaEditor, 'chosen'>
  /** Returns the skin of the current face, or null if it cannot be prepared. */
  canvas(): Promise<SkinCanvas | null>
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
    const { session, canvas, attempt } = this.#parts
    const name = this.offered.peek()
    if (name === null) return
    this.#painted.value = null
    void attempt(async () => {
      const [{ fillArea }, skin] = await Promise.all([import('./fill-area.ts'), canvas()])
      if (!skin) throw noSkinError(name)
      session.edit(`Fill ${name} with lines`, (document) => fillArea(document, name, skin))
    })
  }
}

function isEmpty({ data }: GrayImage): boolean {
  return data.every((weight) => weight < ON_AREA)
}

function noSkinError(area: string): FurrowError {
  return new FurrowError({
    who: 'Studio',
    problem: `the skin is not ready to fill ${area} with lines`,
    remedy: 'paint again when the face is shown',
  })
}
