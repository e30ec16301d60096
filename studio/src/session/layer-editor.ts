import { type ReadonlySignal, signal } from '@preact/signals'
import { fileNamesOf } from 'furrow/internal'
import type { MapName, StudioDocument } from '../document/document.ts'
import { importMap } from '../document/import-map.ts'
import {
  addLayer,
  type LayerFields,
  moveLayer,
  removeLayer,
  renameLayer,
  setLayer,
  setMap,
  setSculpted,
} from '../document/layers.ts'
import { freeName } from '../document/names.ts'
import { bytesOf } from '../files/dropped-files.ts'
import { bakeStep, layerStep, mapStep, resetSculptingStep, STEP } from '../labels/steps.ts'
import type { OpenedAvatar } from '../open/avatar.ts'
import { saveFile } from '../save-file.ts'
import { type DrawnWork, documentToPack } from './exporting.ts'
import { faceFilesOf } from './face-files.ts'
import { readMap } from './map-file.ts'
import type { Session } from './session.ts'

export interface BakeRun {
  readonly layer: string
  /** Progress, 0..1. */
  readonly fraction: number
}

export interface LayerEditorParts {
  session: Session
  /** Returns the document with its drawn maps, or null if no document is open. */
  work(): Promise<DrawnWork | null>
  avatar(): OpenedAvatar | null
  /** Runs a task and shows its error. */
  attempt(task: () => unknown): unknown
}

/** Edits the document's layers, imports and bakes their maps, and saves maps as images. */
export class LayerEditor {
  readonly #parts: LayerEditorParts
  readonly #bake = signal<BakeRun | null>(null)
  #abort: AbortController | null = null

  constructor(parts: LayerEditorParts) {
    this.#parts = parts
  }

  get run(): ReadonlySignal<BakeRun | null> {
    return this.#bake
  }

  add(): void {
    this.#edit(STEP.addLayer, (document) => addLayer(document, freeName(document.layers, 'layer')))
  }

  remove(name: string): void {
    this.#edit(layerStep('Remove', name), (document) => removeLayer(document, name))
  }

  rename(name: string, newName: string): void {
    this.#edit(layerStep('Rename', name), (document) => renameLayer(document, name, newName))
  }

  /** Moves a layer in the list. @param by -1 moves it up, 1 moves it down. */
  move(name: string, by: -1 | 1): void {
    this.#edit(layerStep('Move', name), (document) => {
      const index = document.layers.findIndex((layer) => layer.name === name) + by
      return index < 0 || index >= document.layers.length ? document : moveLayer(document, name, index)
    })
  }

  set(name: string, fields: LayerFields): void {
    const key = `${Object.keys(fields).join()} of ${name}`
    this.#edit(layerStep('Change', name), (document) => setLayer(document, name, fields), key)
  }

  /** Ends the undo step of consecutive calls of `set`. */
  settle(): void {
    this.#parts.session.settle()
  }

  removeMap(name: string, map: MapName): void {
    this.#edit(mapStep('Remove', map, name), (document) => setMap(document, name, map, undefined))
  }

  /** Removes what brushes have sculpted on a layer. */
  resetSculpted(name: string): void {
    this.#edit(resetSculptingStep(name), (document) => setSculpted(document, name, null))
  }

  /** Imports an image as a map of a layer, in one undo step; see `importMap`. Rejects with a FurrowError if the image is unsupported. */
  async importMap(name: string, map: MapName, file: File): Promise<void> {
    const { session } = this.#parts
    const size = session.document.peek()?.mapSize
    if (size === undefined) return
    const image = await readMap(file, map, size)
    session.edit(mapStep('Import', map, name), (document) => importMap(document, name, map, image))
  }

  /**
   * Bakes a sculpt (a detailed model of the wrinkled face) into the normal map of a layer. The map then shows pores as well as wrinkles, so the
   * layer's kind becomes `replace`. Cancels a running bake.
   */
  bake(name: string, sculpt: File): void {
    this.cancelBake()
    const abort = new AbortController()
    this.#abort = abort
    this.#bake.value = { layer: name, fraction: 0 }
    this.#parts.attempt(async () => {
      try {
        await this.#bakeInto(name, sculpt, abort.signal)
      } catch (error) {
        if (!abort.signal.aborted) throw error
      } finally {
        if (this.#abort === abort) this.#endBake()
      }
    })
  }

  cancelBake(): void {
    this.#abort?.abort()
    this.#endBake()
  }

  /**
   * Saves the images of maps and areas: a single image as a file, several images as a .zip.
   *
   * @param only prefix of paths in the project folder. Images with other paths are skipped.
   */
  save(only = ''): void {
    this.#parts.attempt(async () => {
      const work = await this.#parts.work()
      if (!work) return
      const { avatar } = work
      const { folderFilesInWorker } = await import('../export/in-worker.ts')
      const all = await folderFilesInWorker(documentToPack(work), [])
      const images = all.filter(({ path }) => /^(layers|areas)\//.test(path) && path.startsWith(only))
      if (images.length === 1) {
        const [{ path, content }] = images
        const name = path.replace(/^[^/]*\//, '').replaceAll('/', '-')
        saveFile(new Blob([content as BlobPart]), `${avatar.name}-${name}`)
        return
      }
      const { zipFolder } = await import('../files/zip.ts')
      const folder = `${avatar.name}-maps`
      saveFile(await zipFolder(images, folder), `${folder}.zip`)
    })
  }

  saveMap(name: string, map: MapName): void {
    const layers = this.#parts.session.document.peek()?.layers ?? []
    const index = layers.findIndex((layer) => layer.name === name)
    this.save(`layers/${fileNamesOf(layers.map((layer) => layer.name))[index]}/${map}.`)
  }

  async #bakeInto(name: string, sculpt: File, signal: AbortSignal): Promise<void> {
    const { session } = this.#parts
    const [document, avatar] = [session.document.peek(), this.#parts.avatar()]
    if (!document || !avatar) return
    const { bakeInWorker } = await import('../export/in-worker.ts')
    const onProgress = (done: number, total: number) => {
      if (!signal.aborted) this.#bake.value = { layer: name, fraction: done / total }
    }
    const target = {
      face: await faceFilesOf(avatar),
      mesh: avatar.skins[avatar.skin].target.mesh,
      size: document.mapSize,
    }
    const high = { name: sculpt.name, bytes: await bytesOf(sculpt, sculpt.name) }
    const bytes = await bakeInWorker(high, target, { onProgress, signal })
    if (signal.aborted) return
    session.edit(bakeStep(sculpt.name), (old) => {
      const baked = setMap(old, name, 'normal', { mimeType: 'image/png', bytes })
      return setLayer(baked, name, { kind: 'replace' })
    })
  }

  #endBake(): void {
    this.#abort = null
    this.#bake.value = null
  }

  #edit(label: string, operation: (document: StudioDocument) => StudioDocument, key?: string): void {
    this.#parts.attempt(() => this.#parts.session.edit(label, operation, key))
  }
}
