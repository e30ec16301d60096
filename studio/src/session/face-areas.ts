import type { AreaConvention } from 'furrow'
import { readArea } from '../area-file.ts'
import type { Messages } from '../messages.ts'
import type { ShownFace } from '../viewer/shown-face.ts'
import type { AreaEditor } from './area-editor.ts'

/** Adds and removes areas: of the document, or where there is none of the face on the stage alone. */
export class FaceAreas {
  readonly #face: ShownFace
  readonly #editor: AreaEditor
  readonly #messages: Messages

  constructor(face: ShownFace, editor: AreaEditor, messages: Messages) {
    this.#face = face
    this.#editor = editor
    this.#messages = messages
  }

  async add(files: readonly File[], convention: AreaConvention): Promise<void> {
    for (const file of files) {
      await this.#messages.attempt(async () => {
        const area = await readArea(file, convention)
        if (this.#editor.hasDocument) return this.#editor.add(area)
        this.#face.change((viewer) => {
          viewer.addArea(area)
          // Fully active, so that the new area is visible at once.
          viewer.wrinkles?.setActivation(area.name, 1)
          this.#messages.note(`Added area ${area.name}`)
        })
      })
    }
  }

  remove(name: string): void {
    this.#face.change((viewer) => {
      this.#face.hovered.value = null
      if (this.#editor.hasDocument) this.#editor.remove(name)
      else viewer.removeArea(name)
      this.#messages.note(`Removed area ${name}`)
    })
  }
}
