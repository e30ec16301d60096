import { computed, effect, type ReadonlySignal } from '@preact/signals'
import type { Skin } from 'furrow/auto'
import type { RecognisedShape, ShapeCorrection } from 'furrow/internal'
import { correctShape, removeCorrections } from '../document/shapes.ts'
import { correctedSkin, type SkinSource } from '../open/skin-source.ts'
import { Recognition } from './recognition.ts'
import type { Session } from './session.ts'

/** Blendshape of the skin. */
export interface ShapeRow {
  readonly name: string
  /** Recognition result, or undefined. */
  readonly recognised: RecognisedShape | undefined
  /** Chosen ARKit name, null for "none of these", undefined if not corrected. */
  readonly correction: string | null | undefined
}

/** Lists the recognised blendshapes of the skin and corrects them. */
export class ShapeEditor {
  readonly #session: Session
  readonly #source: ReadonlySignal<SkinSource | null>
  readonly #recognition = new Recognition()

  /** @param source current skin, or null. */
  constructor(session: Session, source: ReadonlySignal<SkinSource | null>) {
    this.#session = session
    this.#source = source
    effect(() => {
      source.value
      this.#recognition.forget()
    })
  }

  readonly #corrections = computed(() => this.#session.document.value?.shapes ?? NONE)

  /** Skin with corrections, or null. */
  readonly skin: ReadonlySignal<Skin | null> = computed(() => {
    const source = this.#source.value
    return source && correctedSkin(source, this.#corrections.value)
  })

  /** Rows, or null before recognition. */
  readonly rows: ReadonlySignal<readonly ShapeRow[] | null> = computed(() => {
    const shapes = this.#recognition.result.value?.shapes
    const targets = this.skin.value?.targets
    if (!shapes || !targets) return null
    return targets.map(({ name, correction }, i) => {
      const isOld = shapes[i].by === 'correction' && correction === undefined
      return { name, recognised: isOld ? undefined : shapes[i], correction }
    })
  })

  /** Whether recognition used the current corrections: a correction can affect other blendshapes. */
  readonly isCurrent = computed(() => this.#recognition.result.value?.skin === this.skin.value)

  get isRunning(): ReadonlySignal<boolean> {
    return this.#recognition.isRunning
  }

  /** Recognises the blendshapes with the current corrections. Rejects with a FurrowError if that fails. */
  async recognise(): Promise<void> {
    const skin = this.skin.peek()
    if (skin && !this.isCurrent.peek()) await this.#recognition.run(skin)
  }

  /**
   * Corrects a blendshape. Repeated corrections of it are one undo step until `settle`, because arrow keys step through a list.
   *
   * @param shape ARKit name, null for "none of these", undefined to remove the correction.
   */
  correct(target: string, shape: string | null | undefined): void {
    const source = this.#source.peek()
    if (!source) return
    const [mesh] = source.meshes
    const index = source.skin.targets.findIndex(({ name }) => name === target)
    const names = (correction: ShapeCorrection) =>
      correctedSkin(source, [correction]).targets[index]?.correction !== undefined
    this.#session.edit(
      `Correct ${target}`,
      (document) =>
        shape === undefined
          ? removeCorrections(document, names)
          : correctShape(document, { mesh, target, ...(shape !== null && { shape }) }),
      `shape ${target}`,
    )
  }

  /** Ends a series of `correct`. */
  settle(): void {
    this.#session.settle()
  }
}

const NONE: readonly ShapeCorrection[] = []
