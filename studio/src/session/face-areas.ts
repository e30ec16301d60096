import { FurrowError } from 'furrow'
import { MAX_AREAS } from 'furrow/internal'
import { readArea } from '../area-file.ts'
import { addedRegionLabel, removedRegionLabel } from '../labels/messages.ts'
import type { Messages } from '../messages.ts'
import type { ShownFace } from '../viewer/shown-face.ts'
import type { AreaEditor } from './area-editor.ts'

/** Adds and removes areas in the document. Without a document, adds and removes them only on the face on the stage. */
export class FaceAreas {
  readonly #face: ShownFace
  readonly #editor: AreaEditor
  readonly #messages: Messages

  constructor(face: ShownFace, editor: AreaEditor, messages: Messages) {
    this.#face = face
    this.#editor = editor
    this.#messages = messages
  }

  /** Adds images as areas. Reports all failed images in one message. */
  async add(files: readonly File[]): Promise<void> {
    await this.#messages.attempt(async () => {
      checkImageCount(files)
      const errors: unknown[] = []
      for (const file of files) await this.#addOne(file).catch((error) => errors.push(error))
      if (errors.length > 0) throw joinedError(errors, files.length)
    })
  }

  async #addOne(file: File): Promise<void> {
    const area = await readArea(file, this.#editor.convention)
    if (this.#editor.hasDocument) return this.#editor.add(area)
    this.#face.change((viewer) => {
      viewer.addArea(area)
      // Full activation makes the new area visible.
      viewer.wrinkles?.setActivation(area.name, 1)
      this.#messages.note(addedRegionLabel(area.name))
    })
  }

  remove(name: string): void {
    this.#face.change((viewer) => {
      this.#face.hovered.value = null
      if (this.#editor.hasDocument) this.#editor.remove(name)
      else viewer.removeArea(name)
      this.#messages.note(removedRegionLabel(name))
    })
  }
}

/** Joins the errors of images, of which there is at least one. @param count number of all images. */
export function joinedError(errors: readonly unknown[], count: number): Error {
  const first = errors[0] as Error
  if (errors.length === 1) return first
  return new Error(`${errors.length} of ${count} images were not added; the first: ${first.message}`)
}

/** @throws FurrowError if there are more images than areas in a document. */
export function checkImageCount(files: readonly File[]): void {
  if (files.length <= MAX_AREAS) return
  throw new FurrowError({
    code: 'out-of-range',
    who: 'Studio',
    problem: 'too many images to add as areas',
    value: files.length,
    limit: `${MAX_AREAS}`,
    remedy: 'drop only the images of this face',
  })
}
