import { computed, effect, type ReadonlySignal } from '@preact/signals'
import type { Skin } from 'furrow/auto'
import type { RecognisedShape, ShapeCorrection } from 'furrow/internal'
import { correctShape, removeCorrections } from '../document/shapes.ts'
import { correctedSkin, type SkinSource } from '../open/skin-source.ts'
import { Recognition } from './recognition.ts'
import type { Session } from './session.ts'

/** A blendshape of the skin. */
export interface ShapeRow {
  readonly name: string
  /** Result of recognition; undefined while there is none. */
  readonly recognised: RecognisedShape | undefined
  /** ARKit's name that an artist chose, null for none of these; undefined where it is not corrected. */
  readonly correction: string | null | undefined
}

/** Lists what the blendshapes of the skin are, and corrects it. */
export class ShapeEditor {
  readonly #session: Session
  readonly #source: ReadonlySignal<SkinSource | null>
  readonly #recognition = new Recognition()

  /** @param source the skin that is worked on; null for none. */
  constructor(session: Session, source: ReadonlySignal<SkinSource | null>) {
    this.#session = session
    this.#source = source
    effect(() => {
      source.value
      this.#recognition.forget()
    })
  }

  readonly #corrections = computed(() => this.#session.document.value?.shapes ?? NONE)

  /** The skin with its corrections; null where there is none. */
  readonly skin: ReadonlySignal<Skin | null> = computed(() => {
    const source = this.#source.value
    return source && correctedSkin(source, this.#corrections.value)
  })

  /** Null before the blendshapes are recognised. */
  readonly rows: ReadonlySignal<readonly ShapeRow[] | null> = computed(() => {
    const shapes = this.#recognition.result.value?.shapes
    const targets = this.skin.value?.targets
    if (!shapes || !targets) return null
    return targets.map(({ name, correction }, i) => {
      const isOld = shapes[i].by === 'correction' && correction === undefined
      return { name, recognised: isOld ? undefined : shapes[i], correction }
    })
  })

  /** Whether the blendshapes are recognised with the present corrections, which other blendshapes may depend on. */
  readonly isCurrent = computed(() => this.#recognition.result.value?.skin === this.skin.value)

  get isRunning(): ReadonlySignal<boolean> {
    return this.#recognition.isRunning
  }

  /** Recognises the blendshapes with the present corrections. Rejects with a FurrowError where that fails. */
  async recognise(): Promise<void> {
    const skin = this.skin.peek()
    if (skin && !this.isCurrent.peek()) await this.#recognition.run(skin)
  }

  /**
   * Corrects what a blendshape is. Changes of the same one are one step to undo until `settle`: a list is gone through by the keyboard.
   *
   * @param shape ARKit's name, null for none of these; undefined leaves it to Furrow.
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
