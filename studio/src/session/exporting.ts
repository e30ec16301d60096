import { type ReadonlySignal, signal } from '@preact/signals'
import type { HeightMap } from 'furrow/author'
import type { DocumentToPack, StrokeMaps } from '../document/packed-layers.ts'
import type { ExportedFace, ExportOptions } from '../export/export-document.ts'
import type { OpenedAvatar } from '../open/avatar.ts'
import type { DrawnDocument } from '../viewer/document-view.ts'
import { faceFilesOf } from './face-files.ts'

/** An export: how far it is, or what it gave. */
export type ExportState =
  | { kind: 'running'; fraction: number }
  | { kind: 'done'; name: string; face: ExportedFace }

/** A document with all that is drawn of it, and its avatar. */
export interface DrawnWork {
  drawn: DrawnDocument
  avatar: OpenedAvatar
  /** Of strokes, by the names of layers that have some. */
  heights: ReadonlyMap<string, HeightMap>
}

/** Exports the face in a worker, one at a time. */
export class Exporting {
  readonly #state = signal<ExportState | null>(null)
  #abort: AbortController | null = null

  /** Null before anything was exported, and when the document has changed since. */
  get state(): ReadonlySignal<ExportState | null> {
    return this.#state
  }

  /** Rejects with what `exportDocument` throws. */
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
      const following = { onProgress, signal: abort.signal }
      const face = await exportDocumentInWorker(await faceFilesOf(avatar), source, options, following)
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

  /** Ends the run, and forgets what was exported. */
  cancel(): void {
    this.#abort?.abort()
    this.#abort = null
    this.#state.value = null
  }
}

/** The document with the maps of its strokes, and the names of the mesh and material that it is for. */
export function documentToPack({ drawn: { document, maps }, avatar, heights }: DrawnWork): DocumentToPack {
  const { skins, skin } = avatar
  const drawn = document.layers.flatMap(({ name }, i): [string, StrokeMaps][] => {
    const { normal, occlusion } = maps[i]
    const own = heights.get(name)
    return own && occlusion ? [[name, { normal, occlusion, heights: own }]] : []
  })
  return {
    document: { ...skins[skin].target, ...document } as DocumentToPack['document'],
    drawn: new Map(drawn),
  }
}

/** `avatar.vrm` becomes `avatar-wrinkled.vrm`; files of several parts become one `.glb`. */
function nameOf({ name, files: [face] }: OpenedAvatar): string {
  return `${name}-wrinkled.${/\.vrm$/i.test(face.path) ? 'vrm' : 'glb'}`
}
