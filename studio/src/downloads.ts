import type { Messages } from './messages.ts'
import { saveFile } from './save-file.ts'
import { savePicture } from './save-picture.ts'
import type { Saving } from './session/saving.ts'
import type { Workspace } from './session/workspace.ts'
import type { Viewer } from './viewer/viewer.ts'

/** Files and text that the page gives to the user. Errors are shown. */
export class Downloads {
  readonly #workspace: Workspace
  readonly #saving: Saving
  readonly #messages: Messages

  constructor(workspace: Workspace, saving: Saving, messages: Messages) {
    this.#workspace = workspace
    this.#saving = saving
    this.#messages = messages
  }

  /** The exported face, once it is made. */
  export(): void {
    const state = this.#workspace.exporting.state.peek()
    if (state?.kind === 'done') saveFile(new Blob([state.face.bytes as BlobPart]), state.name)
  }

  project(): Promise<unknown> {
    return this.#messages.attempt(async () => {
      const project = await this.#saving.zip()
      if (project) saveFile(project.file, project.name)
    })
  }

  /** The project in its folder on the disk; see `Saving`. */
  folder(isOther: boolean): Promise<unknown> {
    return this.#messages.attempt(async () => {
      const name = await this.#saving.toFolder(isOther)
      if (name !== null) this.#messages.note(`Saved to the folder ${name}`)
    })
  }

  /** The project in its folder, or else as a file. */
  save(): Promise<unknown> {
    return this.#saving.folder.peek() ? this.folder(false) : this.project()
  }

  /** To the clipboard. */
  copyCode(text: string): Promise<unknown> {
    return this.#messages.attempt(async () => {
      await navigator.clipboard.writeText(text)
      this.#messages.note('Copied the code')
    })
  }

  /** What the stage shows. */
  picture(viewer: Viewer | null, expression: string | null): Promise<unknown> {
    return this.#messages.attempt(async () => {
      if (!viewer) return
      viewer.draw()
      const words = ['furrow', viewer.avatar.name, expression, viewer.look.name]
      await savePicture(viewer.canvas, `${words.filter(Boolean).join('-')}.png`)
      this.#messages.note('Saved the picture')
    })
  }

  /** The skin's UV layout, to paint over. */
  uvLayout(viewer: Viewer | null): Promise<unknown> {
    return this.#messages.attempt(async () => {
      if (!viewer) return
      const { drawUvPicture } = await import('./texture/uv-picture.ts')
      const { skins, skin } = viewer.avatar
      await savePicture(drawUvPicture(skins[skin].meshes), `${viewer.avatar.name}-uv.png`)
      this.#messages.note('Saved the UV layout: paint over it')
    })
  }
}
