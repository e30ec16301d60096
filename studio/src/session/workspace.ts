import { effect, type ReadonlySignal, signal } from '@preact/signals'
import { FurrowError } from 'furrow'
import type { AutoWrinkles } from 'furrow/author'
import { DEFAULT_AREA_SIZE, halfSide } from 'furrow/internal'
import type { TargetNames } from 'furrow-files'
import { automaticDocument, layersLeft, remake } from '../document/automatic.ts'
import { blankDocument } from '../document/blank.ts'
import type { AutoSettings, ImageFile, LayerStroke, StudioDocument } from '../document/document.ts'
import { MapMaker } from '../draw/map-maker.ts'
import type { ExportOptions } from '../export/export-document.ts'
import type { Project } from '../keep/project.ts'
import { nextTask } from '../later.ts'
import { type OpenedAvatar, openAvatar } from '../open/avatar.ts'
import { correctedSkin, type SkinSource, skinSource } from '../open/skin-source.ts'
import { skinOfDocument } from '../open/skins.ts'
import type { DrawnDocument } from '../viewer/document-view.ts'
import { Automatic } from './automatic.ts'
import { type DrawnWork, Exporting } from './exporting.ts'
import { faceFilesOf } from './face-files.ts'
import { Keeping } from './keeping.ts'
import { Latest } from './latest.ts'
import { grayFile } from './map-file.ts'
import { Session } from './session.ts'

/** What automatic wrinkles are made with at first. */
export const AUTO_SETTINGS: AutoSettings = { strength: 1, size: 1024, seed: 1 }

/** Side in texels of the maps of previews. */
const PREVIEW_SIZE = 256

/**
 * The face that is worked on: its document, and what is computed from it. Data flows one way: the document changes, its maps are drawn, and
 * `drawn` changes.
 */
export class Workspace {
  readonly session = new Session()
  readonly automatic = new Automatic()
  readonly exporting = new Exporting()
  readonly keeping: Keeping
  readonly #settings = signal<AutoSettings>(AUTO_SETTINGS)
  readonly #drawn = signal<DrawnDocument | null>(null)
  readonly #maps: MapMaker
  readonly #onError: (error: unknown) => void
  #avatar: OpenedAvatar | null = null
  readonly #source = signal<SkinSource | null>(null)
  /** A project whose avatar is about to be shown. */
  #project: { project: Project; root: OpenedAvatar['root'] } | null = null
  #drawing: Promise<void> | null = null
  /** A slider moves on while a preview is made. */
  readonly #previews = new Latest((settings: AutoSettings) => this.#preview(settings))

  /** What the automatic wrinkles of the next avatars are made with at first. */
  firstSettings = AUTO_SETTINGS

  /** @param onError is told of what goes wrong while the page goes on. */
  constructor(onError: (error: unknown) => void) {
    this.#onError = onError
    this.#maps = new MapMaker(onError)
    this.keeping = new Keeping(this.session)
    effect(() => {
      const document = this.session.document.value
      if (document?.auto) this.#settings.value = document.auto
      this.exporting.cancel()
      void this.#draw()
    })
  }

  /** The last document whose maps are drawn, or a preview; null for a plain face, or one whose wrinkles are not the document's. */
  get drawn(): ReadonlySignal<DrawnDocument | null> {
    return this.#drawn
  }

  /** The skin that is worked on; null where there is none. */
  get source(): ReadonlySignal<SkinSource | null> {
    return this.#source
  }

  /** Settings of the automatic wrinkles. */
  get settings(): ReadonlySignal<AutoSettings> {
    return this.#settings
  }

  /**
   * Opens a project: its avatar, to be shown, whose document `open` then takes. Rejects with a FurrowError where it cannot be.
   *
   * @param take takes it from the tab that has it.
   */
  async openProject(id: string, take = false): Promise<OpenedAvatar> {
    const project = await this.keeping.open(id, take)
    try {
      const [face, ...others] = project.files.map(({ path, file }) => ({
        path,
        file: new File([file], path),
      }))
      const avatar = await openAvatar(face, { files: [face, ...others] })
      this.#project = { project, root: avatar.root }
      return { ...avatar, skin: skinOfDocument(avatar, project.opened) }
    } catch (error) {
      await project.close()
      throw error
    }
  }

  /** Begins with another avatar, or another skin of it; one without wrinkles gets automatic ones. The last one's document is closed at once. */
  async open(avatar: OpenedAvatar): Promise<void> {
    const isSame = this.#avatar !== null && isSameWork(avatar, this.#avatar)
    this.#avatar = avatar
    if (isSame) return
    const project = this.#project?.root === avatar.root ? this.#project.project : null
    this.#project = null
    this.#endAuto()
    const left = project ? undefined : this.keeping.leave()
    this.session.open(null)
    this.#source.value = null
    this.#maps.close()
    this.#drawn.value = null
    if (left) await left
    // In a task of its own: a skin of a million vertices takes long to read.
    await nextTask()
    if (avatar !== this.#avatar) return
    const opened = project?.opened ?? avatar.document
    const source = avatar.skins[avatar.skin].wrinkles && !opened ? null : skinSource(avatar)
    this.#source.value = source
    this.#settings.value = this.firstSettings
    if (opened && source) this.session.open(opened)
    this.keeping.follow(avatar, project)
    if (source && !opened) await this.#begin(source)
  }

  /** Begins with automatic wrinkles; where there are none, with skin to paint and draw on. */
  async #begin(source: SkinSource): Promise<void> {
    const auto = source.skin.targets.length > 0 ? this.firstSettings : undefined
    try {
      if (auto) await this.makeAuto(auto)
    } finally {
      const isNone = source === this.#source.peek() && !this.session.document.peek()
      if (isNone) this.session.open({ ...this.#target, ...blankDocument(auto) })
    }
  }

  /** Makes a document of the wrinkles that the avatar's file has, so that they can be changed. Rejects with a FurrowError where it cannot be. */
  async editWrinkles(): Promise<void> {
    const avatar = this.#avatar
    const source = avatar && skinSource(avatar)
    if (!avatar || !source || this.session.document.peek()) return
    const { readDocumentInWorker, readProjectInWorker } = await import('../export/in-worker.ts')
    const { material } = avatar.skins[avatar.skin].target
    const document = avatar.folder
      ? (await readProjectInWorker(avatar.folder)).document
      : await readDocumentInWorker(await faceFilesOf(avatar), material)
    if (!document || avatar !== this.#avatar) return
    this.#source.value = source
    this.session.open({ ...this.#target, ...document })
  }

  /** Ends the run that makes automatic wrinkles; what it previewed is shown no longer. */
  cancelAuto(): void {
    this.#endAuto()
    void this.#draw()
  }

  /** Exports the document as it is drawn; see `Exporting`. */
  async export(options: ExportOptions): Promise<void> {
    const work = await this.drawnWork()
    if (work) await this.exporting.start(work, options)
  }

  /** The avatar and its document once all maps are drawn; null where there is none, or where they cannot be drawn, which is told. */
  async drawnWork(): Promise<DrawnWork | null> {
    await this.#draw()
    const [drawn, avatar] = [this.#drawn.peek(), this.#avatar]
    if (!drawn || !avatar || drawn.document !== this.session.document.peek()) return null
    return { drawn, avatar, heights: await this.#maps.heights(drawn.document, this.#source.peek()!) }
  }

  /** Makes the automatic wrinkles anew; those that were changed by hand stay. Rejects with a FurrowError where there are none. */
  async makeAuto(chosen: AutoSettings): Promise<void> {
    const avatar = this.#avatar
    const settings = this.#withCorrections(chosen)
    this.#endAuto()
    const wrinkles = await this.#runAuto(settings)
    if (!wrinkles) return
    const bloods = wrinkles.blood.maps.map(halfSide)
    const bloodMaps = await Promise.all(
      bloods.map((map, i) => grayFile(map, `blood of ${wrinkles.layers[i].name}`)),
    )
    if (avatar !== this.#avatar) return
    const document = this.#documentOf(wrinkles, settings, bloodMaps)
    await this.#maps.adopt(document, wrinkles, bloods, this.#source.peek()!)
    if (avatar !== this.#avatar) return
    if (!this.session.document.value) this.session.open(document)
    else this.session.edit('Make automatic wrinkles', (old) => remake(old, document))
  }

  /** Tells which stroke is likely to be edited next; null for none. */
  prepareEdit(stroke: LayerStroke | null): void {
    this.#maps.prepare(stroke)
  }

  /** Shows small automatic wrinkles while a control moves; the document stays. What comes while a preview is made waits, the last of it alone. */
  previewAuto(chosen: AutoSettings): Promise<void> {
    const settings = this.#withCorrections(chosen)
    this.#settings.value = settings
    return this.#previews.run(settings)
  }

  /** Settings with the corrections of blendshapes that the document has now. */
  #withCorrections({ shapes: _, ...settings }: AutoSettings): AutoSettings {
    const shapes = this.session.document.peek()?.shapes
    return { ...settings, ...(shapes && { shapes }) }
  }

  #endAuto(): void {
    this.#previews.drop()
    this.automatic.cancel()
  }

  async #preview(settings: AutoSettings): Promise<void> {
    const wrinkles = await this.#runAuto(settings, PREVIEW_SIZE)
    if (!wrinkles) return
    const document = this.#documentOf(wrinkles, settings)
    const { layers, blood } = wrinkles
    const maps = layers.map(({ normal, occlusion }, i) => ({ normal, occlusion, blood: blood.maps[i] }))
    this.#drawn.value = { document, maps, changes: new Map() }
  }

  async #runAuto(settings: AutoSettings, size = settings.size): Promise<AutoWrinkles | null> {
    const source = this.#source.peek()
    if (!source) return null
    this.#settings.value = settings
    const layers = layersLeft(this.session.document.peek())
    const { shapes = [], ...others } = settings
    const options = { ...others, size, areaSize: this.#areaSize, layers }
    const wrinkles = await this.automatic.make({ ...source, skin: correctedSkin(source, shapes) }, options)
    if (!wrinkles) return null
    if (wrinkles.emptyReason !== undefined) throw withoutAreas(wrinkles.emptyReason)
    return wrinkles
  }

  #documentOf(
    wrinkles: AutoWrinkles,
    settings: AutoSettings,
    bloodMaps?: readonly ImageFile[],
  ): StudioDocument {
    return automaticDocument(wrinkles, settings, this.#areaSize, this.#target, bloodMaps)
  }

  get #areaSize(): number {
    return this.session.document.peek()?.areaSize ?? DEFAULT_AREA_SIZE
  }

  /** Names of the skin: a project is opened with the one that was chosen. */
  get #target(): TargetNames {
    const { skins, skin } = this.#avatar!
    return skins[skin].target
  }

  /** Draws the maps of the document; of those that follow each other quickly, the last one. */
  #draw(): Promise<void> {
    this.#drawing ??= this.#drawAll().finally(() => {
      this.#drawing = null
    })
    return this.#drawing
  }

  async #drawAll(): Promise<void> {
    try {
      for (;;) {
        const document = this.session.document.peek()
        if (!document || document === this.#drawn.peek()?.document) return
        const isOld = () => document !== this.session.document.peek()
        try {
          const maps = await this.#maps.make(document, this.#source.peek()!)
          if (!isOld()) this.#drawn.value = { document, maps, changes: this.#maps.takeChanges() }
        } catch (error) {
          // Another avatar was opened meanwhile.
          if (!isOld()) throw error
        }
      }
    } catch (error) {
      this.#onError(error)
    }
  }
}

/** Whether an avatar is shown again, as it is after another renderer was chosen. */
function isSameWork(a: OpenedAvatar, b: OpenedAvatar): boolean {
  const [skin, other] = [a.skins[a.skin], b.skins[b.skin]]
  return (
    a.root === b.root && a.skin === b.skin && a.document === b.document && skin.wrinkles === other.wrinkles
  )
}

function withoutAreas(reason: string): FurrowError {
  return new FurrowError({
    who: 'Studio',
    problem: `no wrinkles can be made: ${reason}`,
    remedy: 'paint areas and draw strokes by hand, or choose another skin',
  })
}
