import type { Messages } from './messages.ts'
import { saveFile } from './save-file.ts'
import { savePicture } from './save-picture.ts'
import type { Workspace } from './session/workspace.ts'
import type { Viewer } from './viewer/viewer.ts'

/** Files that the page offers as downloads. Errors are shown. */
export class Downloads {
  readonly #workspace: Workspace
  readonly #messages: Messages

  constructor(workspace: Workspace, messages: Messages) {
    this.#workspace = workspace
    this.#messages = messages
  }

  /** The exported face, once it is made. */
  export(): void {
    const state = this.#workspace.exporting.state.peek()
    if (state?.kind === 'done') saveFile(new Blob([state.face.bytes as BlobPart]), state.name)
  }

  project(): Promise<unknown> {
    return this.#messages.attempt(async () => {
      const project = await this.#workspace.project()
      if (project) saveFile(project.file, project.name)
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
      const { drawUvPicture } = await import('./uv-picture.ts')
      const { skins, skin } = viewer.avatar
      await savePicture(drawUvPicture(skins[skin].meshes), `${viewer.avatar.name}-uv.png`)
      this.#messages.note('Saved the UV layout: paint over it')
    })
  }
}
