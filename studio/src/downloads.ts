import { jsonFile } from 'furrow-files'
import { presetOf } from './document/preset.ts'
import type { ExportOptions } from './export/export-document.ts'
import { NOTE, savedLabel, savedPresetLabel, savedToFolderLabel } from './labels/messages.ts'
import type { Live } from './live/live.ts'
import type { Messages } from './messages.ts'
import { saveFile } from './save-file.ts'
import { savePicture } from './save-picture.ts'
import type { Saving } from './session/saving.ts'
import type { Workspace } from './session/workspace.ts'
import type { Viewer } from './viewer/viewer.ts'

/** Saves files and copies text for the user. Shows errors. */
export class Downloads {
  readonly #workspace: Workspace
  readonly #saving: Saving
  readonly #messages: Messages

  constructor(workspace: Workspace, saving: Saving, messages: Messages) {
    this.#workspace = workspace
    this.#saving = saving
    this.#messages = messages
  }

  /** Packs the avatar with its wrinkles, and saves the file unless the user cancels the export. */
  exportFace(options: ExportOptions): Promise<unknown> {
    return this.#messages.attempt(async () => {
      await this.#workspace.export(options)
      const state = this.#workspace.exporting.state.peek()
      if (state?.kind !== 'done') return
      saveFile(new Blob([state.face.bytes as BlobPart]), state.name)
      this.#messages.note(savedLabel(state.name))
    })
  }

  saveProject(): Promise<unknown> {
    return this.#messages.attempt(async () => {
      const project = await this.#saving.zip()
      if (project) saveFile(project.file, project.name)
    })
  }

  /** Saves the project to its folder on disk; see `Saving`. */
  saveToFolder(isOtherFolder: boolean): Promise<unknown> {
    return this.#messages.attempt(async () => {
      const name = await this.#saving.toFolder(isOtherFolder)
      if (name !== null) this.#messages.note(savedToFolderLabel(name))
    })
  }

  /** Saves the project to its folder if it has one, otherwise as a .zip file. */
  save(): Promise<unknown> {
    return this.#saving.folder.peek() ? this.saveToFolder(false) : this.saveProject()
  }

  /** Saves the settings of automatic wrinkles for use with other avatars. */
  savePreset(viewer: Viewer | null): void {
    const { session, settings } = this.#workspace
    if (!viewer || !session.document.peek()?.auto) return
    // The settings that the page shows. Wrinkles may still be made with them.
    const text = jsonFile({ version: 1, ...presetOf(settings.peek()) }) as BlobPart
    const name = `${viewer.avatar.name}-preset.json`
    saveFile(new Blob([text], { type: 'application/json' }), name)
    this.#messages.note(savedPresetLabel(name))
  }

  /** Saves the calibration of a person for the source that runs. */
  saveCalibration({ calibration, sender }: Live): void {
    if (!calibration) return
    const text = jsonFile(calibration) as BlobPart
    saveFile(new Blob([text], { type: 'application/json' }), `calibration-${sender.peek()}.json`)
  }

  copyCode(text: string): Promise<unknown> {
    return this.#messages.attempt(async () => {
      await navigator.clipboard.writeText(text)
      this.#messages.note(NOTE.copiedCode)
    })
  }

  savePicture(viewer: Viewer | null, expression: string | null): Promise<unknown> {
    return this.#messages.attempt(async () => {
      if (!viewer) return
      viewer.draw()
      const words = ['furrow', viewer.avatar.name, expression, viewer.look.name]
      await savePicture(viewer.canvas, `${words.filter(Boolean).join('-')}.png`)
      this.#messages.note(NOTE.savedPicture)
    })
  }

  /** Saves the skin's UV layout as a template for painting. */
  saveUvLayout(viewer: Viewer | null): Promise<unknown> {
    return this.#messages.attempt(async () => {
      if (!viewer) return
      const { drawUvPicture } = await import('./texture/uv-picture.ts')
      const { skins, skin } = viewer.avatar
      await savePicture(drawUvPicture(skins[skin].meshes), `${viewer.avatar.name}-uv.png`)
      this.#messages.note(NOTE.savedLayout)
    })
  }
}
