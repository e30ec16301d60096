import { FurrowError } from 'furrow'
import type { Capture } from '../capture/live-link-face.ts'
import { applyPreset } from '../document/preset.ts'
import type { DroppedFile } from '../files/dropped-files.ts'
import { addedTakeLabel, appliedLabel, loadingFaceLabel, loadingLabel, PROGRESS } from '../labels/messages.ts'
import type { Loading } from '../loading.ts'
import type { Messages } from '../messages.ts'
import { type OpenedAvatar, openDropped } from '../open/avatar.ts'
import { readPreset } from '../open/read-preset.ts'
import { sortFiles } from '../open/sort-files.ts'
import type { Workspace } from '../session/workspace.ts'
import { fetchFace } from '../viewer/faces.ts'
import type { ShownFace } from '../viewer/shown-face.ts'
import type { Viewer } from '../viewer/viewer.ts'
import type { LoadAvatar, ViewerHost } from '../viewer/viewer-host.ts'

export interface OpeningParts {
  host: ViewerHost
  face: ShownFace
  workspace: Workspace
  messages: Messages
  loading: Loading
  /** Asks what dropped images are, and adds them. */
  askImages(images: readonly File[]): Promise<void>
  /** Adds a facial capture to the takes. */
  addCapture(capture: Capture): Promise<void>
  /** Called before an avatar that the user dropped is shown. */
  onDropped(avatar: OpenedAvatar): void
}

/** Opens faces from the server, dropped files and recent projects. */
export class Opening {
  readonly #parts: OpeningParts

  /** Renderer of the first avatar. Later ones use the current renderer. */
  firstKind: Viewer['kind'] = 'webgl'

  constructor(parts: OpeningParts) {
    this.#parts = parts
  }

  open(load: LoadAvatar): Promise<unknown> {
    const { host, face } = this.#parts
    face.settle()
    return host.open(host.viewer?.kind ?? this.firstKind, load)
  }

  /** Returns a function that loads a face from the server. */
  faceLoader(name: string): LoadAvatar {
    const { loading } = this.#parts
    const title = loadingFaceLabel(name)
    return () => {
      loading.show(title, 0)
      return fetchFace(name, (fraction) => loading.show(title, fraction))
    }
  }

  /** Opens a face from the server, as the user wants. */
  openFace(name: string): Promise<void> {
    return this.#parts.messages.attemptOpening(() => this.open(this.faceLoader(name)))
  }

  openProject(id: string): Promise<void> {
    return this.#parts.messages.attemptOpening(() => this.open(() => this.#projectOf(id)))
  }

  /** Takes the project over from another tab, which saves it first. */
  takeOver(): Promise<unknown> {
    return this.open(async () => {
      const project = await this.#parts.workspace.keeping.project()
      return this.#projectOf(project!.id, true)
    })
  }

  /**
   * Opens dropped files: an avatar, or wrinkles, areas, facial captures or a preset for the current avatar.
   *
   * @param list lists the files. Called synchronously, because browsers deny access to dropped files after the event.
   */
  async openFiles(list: () => Promise<DroppedFile[]>): Promise<void> {
    const { messages, loading, askImages, onDropped } = this.#parts
    await messages.attemptOpening(async () => {
      const dropped = await sortFiles(await list())
      if (dropped.kind === 'areas') return askImages(dropped.images.map(({ file }) => file))
      if (dropped.kind === 'captures') return this.#addCapture(dropped.tables)
      if (dropped.kind === 'preset') return this.#applyPreset(dropped.preset)
      await this.open(async (shown) => {
        const name = dropped.kind === 'avatar' ? dropped.face.file.name : dropped.wrinkles.name
        loading.show(loadingLabel(name))
        const avatar = await openDropped(dropped, shown)
        messages.note(avatar.notes.join('. '))
        if (dropped.kind === 'avatar' && !avatar.document) onDropped(avatar)
        return avatar
      })
    })
  }

  async #addCapture(tables: readonly DroppedFile[]): Promise<void> {
    const { host, messages, addCapture } = this.#parts
    const { readCapture } = await import('../capture/read-capture.ts')
    const capture = await readCapture(tables.map(({ file }) => file))
    if (!host.viewer) throw noAvatarError(capture.name)
    await addCapture(capture)
    messages.note(addedTakeLabel(capture.name))
  }

  async #applyPreset(dropped: DroppedFile): Promise<void> {
    const { workspace, messages } = this.#parts
    const preset = await readPreset(dropped)
    await workspace.opened()
    const settings = workspace.session.document.peek()?.auto
    if (!settings) throw noAutomaticError(dropped.path)
    await workspace.makeAuto(applyPreset(settings, preset))
    messages.note(appliedLabel(dropped.path))
  }

  #projectOf(id: string, take = false): Promise<OpenedAvatar> {
    this.#parts.loading.show(PROGRESS.opening)
    return this.#parts.workspace.openProject(id, take)
  }
}

function noAvatarError(capture: string): FurrowError {
  return new FurrowError({
    who: 'Studio',
    problem: `there is no avatar for ${capture} to move`,
    remedy: 'drop one first',
  })
}

function noAutomaticError(preset: string): FurrowError {
  return new FurrowError({
    who: 'Studio',
    problem: `there are no automatic wrinkles to which ${preset} applies`,
    remedy: 'open an avatar without wrinkles first',
  })
}
