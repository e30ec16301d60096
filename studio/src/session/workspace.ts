import { computed, effect, type ReadonlySignal, signal } from '@preact/signals'
import { FurrowError } from 'furrow'
import type { AutoWrinkles } from 'furrow/author'
import type { TargetNames } from 'furrow-files'
import {
  type AutoMaps,
  autoMaps,
  automaticDocument,
  maxAutoLayers,
  remake,
  withoutAutomatic,
} from '../document/automatic.ts'
import { blankDocument } from '../document/blank.ts'
import {
  AUTO_SETTINGS,
  type AutoSettings,
  type ImageFile,
  type LayerStroke,
  type StudioDocument,
} from '../document/document.ts'
import { limited } from '../document/region-strengths.ts'
import { MapMaker } from '../draw/map-maker.ts'
import type { ExportOptions } from '../export/export-document.ts'
import type { Project } from '../keep/project.ts'
import { STEP } from '../labels/steps.ts'
import { nextTask } from '../later.ts'
import { type OpenedAvatar, openAvatar } from '../open/avatar.ts'
import { correctedSkin, type SkinSource, skinSource } from '../open/skin-source.ts'
import { skinOfDocument } from '../open/skins.ts'
import { autoSource } from '../open/surface.ts'
import type { DrawnDocument } from '../viewer/document-view.ts'
import { Automatic } from './automatic.ts'
import { type DrawnWork, Exporting } from './exporting.ts'
import { faceFilesOf } from './face-files.ts'
import { Keeping } from './keeping.ts'
import { Latest } from './latest.ts'
import { encodeMaps } from './map-file.ts'
import { Session } from './session.ts'

/** Width and height of preview maps, texels. */
const PREVIEW_SIZE = 256

/** Document of the current face, and data derived from it. After each change, draws the maps and updates `drawn`. */
export class Workspace {
  readonly session = new Session()
  readonly automatic = new Automatic()
  readonly exporting = new Exporting()
  readonly keeping: Keeping
  readonly #settings = signal<AutoSettings>(AUTO_SETTINGS)
  readonly #beginning = signal<SkinSource | null>(null)
  /** Whether the first wrinkles of the avatar are made and drawn. */
  readonly isBeginning: ReadonlySignal<boolean> = computed(() => {
    return this.#beginning.value !== null && this.#beginning.value === this.#source.value
  })
  readonly #drawn = signal<DrawnDocument | null>(null)
  readonly #maps: MapMaker
  readonly #onError: (error: unknown) => void
  #avatar: OpenedAvatar | null = null
  /** Last call of `open`. */
  #opened: Promise<void> = Promise.resolve()
  readonly #source = signal<SkinSource | null>(null)
  /** Opened project whose avatar is not on the stage yet. */
  #project: { project: Project; root: OpenedAvatar['root'] } | null = null
  #drawing: Promise<void> | null = null
  /** Makes previews while a slider moves, and skips outdated ones. */
  readonly #previews = new Latest((settings: AutoSettings) => this.#preview(settings))

  /** Settings of automatic wrinkles for avatars that are opened from now on. */
  initialSettings = AUTO_SETTINGS

  /** @param onError receives errors of background work. */
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

  /** Last document whose maps are drawn, or a preview. Null if the face has no wrinkles or shows the wrinkles of the avatar's file. */
  get drawn(): ReadonlySignal<DrawnDocument | null> {
    return this.#drawn
  }

  get source(): ReadonlySignal<SkinSource | null> {
    return this.#source
  }

  get settings(): ReadonlySignal<AutoSettings> {
    return this.#settings
  }

  /**
   * Opens a project and returns its avatar. Show the avatar, then pass it to `open`. Rejects with a FurrowError if the project cannot be opened.
   *
   * @param take whether to take the project from another tab that has it open.
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

  /** Switches to another avatar or skin, and closes the previous document. If the skin has no wrinkles, makes automatic wrinkles. */
  open(avatar: OpenedAvatar): Promise<void> {
    this.#opened = this.#open(avatar)
    return this.#opened
  }

  /** Resolves when the wrinkles of the current avatar are made or read, or when that has failed. */
  async opened(): Promise<void> {
    await this.#opened.catch(() => {})
  }

  async #open(avatar: OpenedAvatar): Promise<void> {
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
    // Reading a skin with a million vertices blocks the page, so let the browser handle pending events first.
    await nextTask()
    if (avatar !== this.#avatar) return
    const opened = project?.opened ?? avatar.document
    const source = avatar.skins[avatar.skin].wrinkles && !opened ? null : skinSource(avatar)
    this.#source.value = source
    this.#settings.value = this.initialSettings
    if (opened && source) this.session.open(opened)
    this.keeping.follow(avatar, project)
    if (source && !opened) await this.#begin(source)
  }

  /** Opens a document with automatic wrinkles. If neither blendshapes nor joints wrinkle the skin, opens an empty document. */
  async #begin(source: SkinSource): Promise<void> {
    const isMovable = source.skin.targets.length > 0 || source.limbs.length > 0
    const auto = isMovable ? this.initialSettings : undefined
    this.#beginning.value = source
    try {
      if (auto && autoSource(source, auto)) await this.makeAuto(auto)
    } finally {
      if (this.#beginning.peek() === source) this.#beginning.value = null
      const isEmpty = source === this.#source.peek() && !this.session.document.peek()
      if (isEmpty) this.session.open({ ...this.#target, ...blankDocument(auto) })
    }
  }

  /** Makes an editable document from the wrinkles in the avatar's file. Rejects with a FurrowError if that fails. */
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

  /** Resolves when the face has a document. Makes one from the wrinkles of the avatar's file if necessary. Rejects with a FurrowError if there is none. */
  async editable(): Promise<void> {
    await this.opened()
    await this.editWrinkles()
    if (!this.session.document.peek()) throw noDocumentError()
  }

  /** Cancels automatic wrinkles and hides their preview. */
  cancelAuto(): void {
    this.#endAuto()
    void this.#draw()
  }

  async export(options: ExportOptions): Promise<void> {
    const work = await this.drawnWork()
    if (work) await this.exporting.start(work, options)
  }

  /**
   * Draws all maps of the document, and returns the document with its maps. Returns null if no document is open. If drawing fails, reports the
   * error to `onError` and returns null.
   */
  async drawnWork(): Promise<DrawnWork | null> {
    await this.#draw()
    const [drawn, avatar] = [this.#drawn.peek(), this.#avatar]
    if (!drawn || !avatar || drawn.document !== this.session.document.peek()) return null
    return { drawn, avatar, heights: await this.#maps.heights(drawn.document, this.#source.peek()!) }
  }

  /** Replaces the automatic wrinkles, except wrinkles that the artist has edited. Rejects with a FurrowError if no wrinkles can be made. */
  async makeAuto(chosen: AutoSettings): Promise<void> {
    const avatar = this.#avatar
    const settings = this.#withCorrections(chosen)
    this.#endAuto()
    const source = this.#source.peek()
    if (source && !autoSource(source, settings)) {
      this.session.edit(STEP.makeWrinkles, (old) => remake(old, withoutAutomatic(old, settings)))
      return
    }
    const wrinkles = await this.#runAuto(settings)
    if (!wrinkles) return
    const used = { ...settings, seed: wrinkles.seed }
    this.#settings.value = used
    const maps = autoMaps(wrinkles)
    const images = await Promise.all(maps.map((each, i) => encodeMaps(each, wrinkles.layers[i].name)))
    if (avatar !== this.#avatar) return
    const document = this.#documentOf(wrinkles, used, images)
    await this.#maps.adopt(document, wrinkles, maps, this.#source.peek()!)
    if (avatar !== this.#avatar) return
    if (!this.session.document.value) this.session.open(document)
    else this.session.edit(STEP.makeWrinkles, (old) => remake(old, document))
  }

  /** Prepares edits of a stroke, so that the first change is as fast as later ones. Null cancels the preparation. */
  prepareEdit(stroke: LayerStroke | null): void {
    this.#maps.prepare(stroke)
  }

  /** Shows automatic wrinkles with small maps, without changing the document. If several calls wait, only the last one takes effect. */
  previewAuto(chosen: AutoSettings): Promise<void> {
    const settings = this.#withCorrections(chosen)
    this.#settings.value = settings
    return this.#previews.run(settings)
  }

  /** Adds the document's blendshape corrections to the settings. */
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
    const maps = layers.map(({ normal, occlusion, onset }, i) => {
      return { normal, occlusion, blood: blood.maps[i], ...(onset && { onset }) }
    })
    this.#drawn.value = { document, maps, changes: new Map() }
  }

  async #runAuto(settings: AutoSettings, size = settings.size): Promise<AutoWrinkles | null> {
    const source = this.#source.peek()
    const found = source && autoSource(source, settings)
    if (!found) return null
    this.#settings.value = settings
    const document = this.session.document.peek()
    const { shapes = [], strengths = {}, kind: _, cloth: __, regions, ...others } = settings
    const options = {
      ...others,
      ...found.options,
      // Regions belong to faces.
      ...(regions && found.skin.targets.length > 0 && { regions }),
      strengths: limited(strengths),
      size,
      // Joints fold small parts of a large skin. `autoWrinkles` then chooses a larger size.
      ...(document && document.areas.length > 0 && { areaSize: document.areaSize }),
      layers: maxAutoLayers(document),
    }
    const { frame, meshes } = source
    const skin = correctedSkin({ skin: found.skin, meshes }, shapes)
    const wrinkles = await this.automatic.make({ skin, frame }, options)
    if (!wrinkles) return null
    if (wrinkles.emptyReason !== undefined) throw noWrinklesError(wrinkles.emptyReason)
    return wrinkles
  }

  #documentOf(
    wrinkles: AutoWrinkles,
    settings: AutoSettings,
    images?: readonly AutoMaps<ImageFile>[],
  ): StudioDocument {
    return automaticDocument(wrinkles, settings, this.#target, images)
  }

  /** Names of the skin's mesh and material. Documents contain them, so that a project opens with the same skin. */
  get #target(): TargetNames {
    const { skins, skin } = this.#avatar!
    return skins[skin].target
  }

  /** Draws the document's maps. If the document changes meanwhile, continues with the changed document. */
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
          // Ignore errors of a document that was replaced while drawing.
          if (!isOld()) throw error
        }
      }
    } catch (error) {
      this.#onError(error)
    }
  }
}

/** Whether the same avatar is shown again, for example after switching the renderer. */
function isSameWork(a: OpenedAvatar, b: OpenedAvatar): boolean {
  const [skin, other] = [a.skins[a.skin], b.skins[b.skin]]
  return (
    a.root === b.root && a.skin === b.skin && a.document === b.document && skin.wrinkles === other.wrinkles
  )
}

function noDocumentError(): FurrowError {
  return new FurrowError({
    who: 'Studio',
    problem: 'this avatar has no project to which the take could belong',
    remedy: 'choose another skin, or open another avatar',
  })
}

function noWrinklesError(reason: string): FurrowError {
  return new FurrowError({
    who: 'Studio',
    problem: `no wrinkles can be made: ${reason}`,
    remedy: 'paint areas and draw strokes by hand, or choose another skin',
  })
}
