import { computed, effect, type ReadonlySignal } from '@preact/signals'
import type { Skin } from 'furrow/auto'
import type { RecognisedShape, ShapeCorrection } from 'furrow/internal'
import { correctShape, removeCorrections } from '../document/shapes.ts'
import { correctShapeStep } from '../labels/steps.ts'
import { correctedSkin, type SkinSource } from '../open/skin-source.ts'
import { Recognition } from './recognition.ts'
import type { Session } from './session.ts'

/** Row in the list of the skin's blendshapes. */
export interface ShapeRow {
  readonly name: string
  /** Recognised meaning. Undefined if it was a correction that the artist has removed since the last recognition. */
  readonly recognised: RecognisedShape | undefined
  /** Meaning that the artist chose: an ARKit name, or null for "none of these". Undefined without a correction. */
  readonly correction: string | null | undefined
}

/** Lists the blendshapes of the skin with their recognised meanings, which the artist can correct. */
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

  /** Current skin with the corrections applied, or null. */
  readonly skin: ReadonlySignal<Skin | null> = computed(() => {
    const source = this.#source.value
    return source && correctedSkin(source, this.#corrections.value)
  })

  /** One row for each blendshape, or null before recognition. */
  readonly rows: ReadonlySignal<readonly ShapeRow[] | null> = computed(() => {
    const shapes = this.#recognition.result.value?.shapes
    const targets = this.skin.value?.targets
    if (!shapes || !targets) return null
    return targets.map(({ name, correction }, i) => {
      const isOld = shapes[i].by === 'correction' && correction === undefined
      return { name, recognised: isOld ? undefined : shapes[i], correction }
    })
  })

  /** Whether the last recognition used the current corrections. A correction can change the recognised meanings of other blendshapes. */
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
   * Corrects a blendshape. All corrections of a blendshape until `settle` are one undo step, because each press of an arrow key in the
   * drop-down list is a correction.
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
      correctShapeStep(target),
      (document) =>
        shape === undefined
          ? removeCorrections(document, names)
          : correctShape(document, { mesh, target, ...(shape !== null && { shape }) }),
      `shape ${target}`,
    )
  }

  /** Ends the undo step of consecutive calls of `correct`. */
  settle(): void {
    this.#session.settle()
  }
}

const NONE: readonly ShapeCorrection[] = []
