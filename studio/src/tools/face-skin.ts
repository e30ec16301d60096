import { computed, effect, type ReadonlySignal, signal } from '@preact/signals'
import type { StudioDocument } from '../document/document.ts'
import { runInTurn } from '../later.ts'
import type { OpenedAvatar } from '../open/avatar.ts'
import type { PaintSkin } from '../paint/paint-skin.ts'
import type { SkinPicker } from '../paint/picker.ts'
import { preparedSkin, prepareSkin } from '../paint/posed-skin.ts'
import type { Session } from '../session/session.ts'
import type { Viewer } from '../viewer/viewer.ts'
import { TexturePicker } from './texture-picker.ts'

/** Skin of the open face in its current pose, with its pickers on the face and on the texture. */
export interface PaintedFace {
  readonly skin: PaintSkin
  readonly picker: SkinPicker
  readonly texture: TexturePicker
}

/** Inputs for preparing the skin of the open face. */
type OpenFace = Pick<StudioDocument, 'scale' | 'areaSize'> & Pick<OpenedAvatar['skins'][number], 'meshes'>

/** Maximum number of vertices of a skin, over all its meshes, to prepare it in advance. Larger skins need hundreds of megabytes. */
const MAX_PREPARED = 500_000

export interface FaceSkinParts {
  session: Session
  viewer: ReadonlySignal<Viewer | null>
  /** Requests the next frame. */
  wake(): void
  /** Runs a task and shows its errors. */
  attempt(task: () => unknown): unknown
}

/** Prepares the skin of the open face for brushes. */
export class FaceSkin {
  readonly #parts: FaceSkinParts
  readonly #version = signal(0)

  constructor(parts: FaceSkinParts) {
    this.#parts = parts
    this.#prepareSkins()
  }

  /** Version number, incremented when a skin is ready. */
  get version(): ReadonlySignal<number> {
    return this.#version
  }

  /** The open face and the settings of its document, or null. */
  get open(): OpenFace | null {
    const [viewer, document] = [this.#parts.viewer.peek(), this.#parts.session.document.peek()]
    if (!viewer || !document) return null
    const { skins, skin } = viewer.avatar
    const { scale, areaSize } = document
    return { meshes: skins[skin].meshes, scale, areaSize }
  }

  /**
   * Returns the open face in its current pose, or null until its skin is ready.
   *
   * @param size width and height of the painted image, texels.
   */
  at(size: number): PaintedFace | null {
    const { open } = this
    const made = open && preparedSkin(open.meshes, open.scale, size)
    if (!made) return null
    const { skin, picker } = made
    return { skin, picker, texture: new TexturePicker(skin, picker, size) }
  }

  /** Returns a promise that settles when the skin is ready, or null if there is nothing to wait for. */
  preparation(size: number): Promise<unknown> | null {
    const { open } = this
    if (!open || preparedSkin(open.meshes, open.scale, size)) return null
    return Promise.resolve(this.#parts.attempt(() => this.#prepare(open, size)))
  }

  /** Prepares the skin of each opened face in advance, unless it is too large. Errors are shown only when painting starts. */
  #prepareSkins(): void {
    const { viewer, session } = this.#parts
    const avatar = computed(() => viewer.value?.avatar)
    const scale = computed(() => session.document.value?.scale)
    const size = computed(() => session.document.value?.areaSize)
    effect(() => {
      avatar.value
      scale.value
      size.value
      const { open } = this
      if (!open || isLarge(open.meshes)) return
      return runInTurn(() => void this.#prepare(open, open.areaSize).catch(() => {}))
    })
  }

  async #prepare({ meshes, scale }: OpenFace, size: number): Promise<void> {
    await prepareSkin(meshes, scale, size)
    this.#version.value++
    this.#parts.wake()
  }
}

function isLarge(meshes: OpenFace['meshes']): boolean {
  return meshes.reduce((sum, { geometry }) => sum + geometry.attributes.position.count, 0) > MAX_PREPARED
}
