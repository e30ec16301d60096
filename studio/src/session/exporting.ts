import { type ReadonlySignal, signal } from '@preact/signals'
import type { HeightMap } from 'furrow/author'
import type { DocumentToPack, StrokeMaps } from '../document/packed-layers.ts'
import type { ExportedFace, ExportOptions } from '../export/export-document.ts'
import type { OpenedAvatar } from '../open/avatar.ts'
import type { DrawnDocument } from '../viewer/document-view.ts'
import { faceFilesOf } from './face-files.ts'

export type ExportState =
  | { kind: 'running'; fraction: number }
  | { kind: 'done'; name: string; face: ExportedFace }

/** Document with its drawn maps, and its avatar. */
export interface DrawnWork {
  drawn: DrawnDocument
  avatar: OpenedAvatar
  /** Drawn height maps. The keys are names of the layers that have strokes or sculpted heights. */
  heights: ReadonlyMap<string, HeightMap>
}

/** Exports the face in a worker. A new export cancels the previous one. */
export class Exporting {
  readonly #state = signal<ExportState | null>(null)
  #abort: AbortController | null = null

  /** State of the last export. Null before the first export, and after the document has changed. */
  get state(): ReadonlySignal<ExportState | null> {
    return this.#state
  }

  /** Starts an export. Rejects with errors of `exportDocument`. */
  async start(work: DrawnWork, options: ExportOptions): Promise<void> {
    this.cancel()
    const abort = new AbortController()
    this.#abort = abort
    this.#state.value = { kind: 'running', fraction: 0 }
    try {
      const { exportDocumentInWorker } = await import('../export/in-worker.ts')
      const onProgress = (done: number, total: number) => {
        if (this.#abort === abort) this.#state.value = { kind: 'running', fraction: done / total }
      }
      const { avatar } = work
      const source = documentToPack(work)
      const taskOptions = { onProgress, signal: abort.signal }
      const face = await exportDocumentInWorker(await faceFilesOf(avatar), source, options, taskOptions)
      if (this.#abort !== abort) return
      this.#abort = null
      this.#state.value = { kind: 'done', name: nameOf(avatar), face }
    } catch (error) {
      if (this.#abort !== abort) return
      this.#abort = null
      this.#state.value = null
      throw error
    }
  }

  /** Cancels the export and clears its result. */
  cancel(): void {
    this.#abort?.abort()
    this.#abort = null
    this.#state.value = null
  }
}

/** Combines the document, the maps of its strokes, and the names of its mesh and material. */
export function documentToPack({ drawn: { document, maps }, avatar, heights }: DrawnWork): DocumentToPack {
  const { skins, skin } = avatar
  const drawn = document.layers.flatMap(({ name, isOnsetDrawn }, i): [string, StrokeMaps][] => {
    const { normal, occlusion, onset } = maps[i]
    const own = heights.get(name)
    if (!own || !occlusion) return []
    return [[name, { normal, occlusion, heights: own, ...(onset && isOnsetDrawn && { onset }) }]]
  })
  return {
    document: { ...skins[skin].target, ...document } as DocumentToPack['document'],
    drawn: new Map(drawn),
  }
}

/** Returns the name of the exported file: `avatar-wrinkled.vrm` for `avatar.vrm`, otherwise `avatar-wrinkled.glb`. */
function nameOf({ name, files: [face] }: OpenedAvatar): string {
  return `${name}-wrinkled.${/\.vrm$/i.test(face.path) ? 'vrm' : 'glb'}`
}
