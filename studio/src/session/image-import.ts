import { effect, type ReadonlySignal, signal } from '@preact/signals'
import { FurrowError, type RgbaImage } from 'furrow'
import { decodeImage } from 'furrow/three'
import type { Messages } from '../messages.ts'
import { checkImageCount, type FaceAreas, joinedError } from './face-areas.ts'
import { guessKind, type ImageKind } from './image-kind.ts'
import type { LayerEditor } from './layer-editor.ts'
import type { Session } from './session.ts'

/** Dropped image whose kind is asked. */
export interface AskedImage {
  readonly file: File
  /** URL of the image while it is asked. */
  readonly url: string
  readonly kind: ImageKind
}

export interface ImageImportParts {
  session: Session
  faceAreas: FaceAreas
  layers: LayerEditor
  messages: Messages
  /** Layer of the selected region or line, if any. */
  layer(): string | undefined
  /** Makes an editable document from the wrinkles in the avatar's file. */
  editWrinkles(): Promise<void>
  /** Decodes an image. Default: `decodeImage`. */
  decode?(file: File, name: string): Promise<RgbaImage>
}

/** Asks what dropped images are, and adds them as regions or as maps of a layer. */
export class ImageImport {
  readonly #parts: ImageImportParts
  readonly #asked = signal<readonly AskedImage[]>([])

  /** Whether the page asks. Setting it to false cancels. */
  readonly isAsking = signal(false)

  constructor(parts: ImageImportParts) {
    this.#parts = parts
    effect(() => {
      if (this.isAsking.value) return
      for (const { url } of this.#asked.peek()) URL.revokeObjectURL(url)
      this.#asked.value = []
    })
  }

  get asked(): ReadonlySignal<readonly AskedImage[]> {
    return this.#asked
  }

  /** Asks what images are. Skips and reports images that cannot be decoded. Rejects with a FurrowError if there are too many. */
  async ask(files: readonly File[]): Promise<void> {
    checkImageCount(files)
    const { decode = decodeImage, messages } = this.#parts
    const asked: AskedImage[] = []
    const errors: unknown[] = []
    for (const file of files) {
      try {
        const kind = guessKind(file.name, await decode(file, file.name))
        asked.push({ file, kind, url: URL.createObjectURL(file) })
      } catch (error) {
        errors.push(error)
      }
    }
    if (errors.length > 0) messages.error(joinedError(errors, files.length))
    if (asked.length === 0) return
    this.isAsking.value = false
    this.#asked.value = asked
    this.isAsking.value = true
  }

  setKind(image: AskedImage, kind: ImageKind): void {
    this.#asked.value = this.#asked.peek().map((each) => (each === image ? { ...each, kind } : each))
  }

  /** Adds the asked images, each in its own undo step. */
  async add(): Promise<void> {
    const { faceAreas } = this.#parts
    const asked = this.#asked.peek()
    this.isAsking.value = false
    const masks = asked.filter(({ kind }) => kind === 'mask').map(({ file }) => file)
    if (masks.length > 0) await faceAreas.add(masks)
    for (const { file, kind } of asked) if (kind !== 'mask') await this.#addMap(file, kind)
  }

  /** Adds a map to the layer of the selection, or to the first layer. */
  async #addMap(file: File, map: Exclude<ImageKind, 'mask'>): Promise<void> {
    const { session, layers, messages, editWrinkles } = this.#parts
    await messages.attempt(async () => {
      if (!session.document.peek()) await editWrinkles()
      const document = session.document.peek()
      if (!document) throw noWrinklesError(file.name)
      const selected = this.#parts.layer()
      const layer = document.layers.find(({ name }) => name === selected) ?? document.layers[0]
      await layers.importMap(layer.name, map, file)
    })
  }
}

function noWrinklesError(image: string): FurrowError {
  return new FurrowError({
    who: 'Studio',
    problem: `there are no wrinkles to which ${image} could be added`,
    remedy: 'open an avatar first, and wait for its wrinkles',
  })
}
