import { proxy, type Remote } from 'comlink'
import { FurrowError } from 'furrow'
import type { StudioDocument } from '../document/document.ts'
import type { DocumentToPack } from '../document/packed-layers.ts'
import type { FaceFiles } from '../files/face-files.ts'
import type { AvatarFile, FolderFile, WrinklesFolder } from '../files/folder-files.ts'
import type { ReadFolder } from '../keep/read-folder.ts'
import { runOnce } from '../workers/run-once.ts'
import type { BakeTarget } from './bake-sculpt.ts'
import type { ExportedFace, ExportOptions, OnProgress } from './export-document.ts'
import type { Tasks } from './worker.ts'

export interface TaskOptions {
  onProgress?: OnProgress
  /** Aborting it terminates the worker. */
  signal?: AbortSignal | undefined
}

/**
 * Runs `exportDocument` in a new worker, on copies of the arguments.
 *
 * @throws Error with the message of `exportDocument`'s error, FurrowError if the worker dies, and the signal's reason if aborted.
 */
export function exportDocumentInWorker(
  face: FaceFiles,
  source: DocumentToPack,
  options: ExportOptions = {},
  { onProgress = () => {}, signal }: TaskOptions = {},
): Promise<ExportedFace> {
  return run((tasks) => tasks.exportDocument(face, source, options, proxy(onProgress)), signal)
}

/** Runs `folderFiles` in a new worker; see `exportDocumentInWorker`. */
export function folderFilesInWorker(
  source: DocumentToPack,
  face: readonly AvatarFile[],
): Promise<FolderFile[]> {
  return run((tasks) => tasks.folderFiles(source, face))
}

/** Runs `readDocument` in a new worker; see `exportDocumentInWorker`. */
export function readDocumentInWorker(face: FaceFiles, material?: string): Promise<StudioDocument | null> {
  return run((tasks) => tasks.readDocument(face, material))
}

/** Runs `readProject` in a new worker; see `exportDocumentInWorker`. */
export function readProjectInWorker({ name, files }: WrinklesFolder): Promise<ReadFolder> {
  return run((tasks) => tasks.readProject(files, name))
}

/** Runs `bakeSculpt` in a new worker; see `exportDocumentInWorker`. */
export function bakeInWorker(
  sculpt: FaceFiles,
  target: BakeTarget,
  { onProgress = () => {}, signal }: TaskOptions = {},
): Promise<Uint8Array> {
  return run((tasks) => tasks.bakeSculpt(sculpt, target, proxy(onProgress)), signal)
}

async function run<T>(task: (tasks: Remote<Tasks>) => Promise<T>, signal?: AbortSignal): Promise<T> {
  signal?.throwIfAborted()
  const worker = new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' })
  return runOnce<Tasks, T>(worker, task, workerError, signal)
}

function workerError(message: string | undefined): FurrowError {
  return new FurrowError({
    code: 'unsupported',
    who: 'Studio',
    problem: 'the worker that packs faces has ended',
    value: message,
    remedy: 'close other pages to free memory, and export again',
  })
}
