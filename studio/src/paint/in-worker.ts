import { transfer } from 'comlink'
import { FurrowError } from 'furrow'
import type { Skin, SkinCanvas } from 'furrow/author'
import { buffersOf, canvasFromArrays, type SkinCanvasArrays } from 'furrow/internal'
import { runOnce } from '../workers/run-once.ts'
import type { SkinData } from './make-skin.ts'
import type { SkinService } from './worker.ts'

/**
 * Runs `makeSkin` in a new worker. Transfers the arrays of the skin to the worker and back, because copying them takes as long as `readSkin`.
 *
 * @returns a promise. Rejects with errors of `makeSkin`, and with a FurrowError if the worker dies.
 */
export function makeSkinInWorker(
  skin: Skin,
  scale: number,
  size: number,
): Promise<{ skin: Skin; made: SkinData }> {
  const moved = transfer(skin, buffersOf(skin))
  return runOnce<SkinService, { skin: Skin; made: SkinData }>(
    startWorker(),
    (service) => service.makeSkin(moved, scale, size),
    workerError,
  )
}

/** Runs `skinCanvas` in a new worker. Rejects like `makeSkinInWorker`. */
export async function makeCanvasInWorker(
  mesh: Pick<Skin, 'positions' | 'uvs' | 'indices'>,
  size: number,
  scale: number,
): Promise<SkinCanvas> {
  const arrays = await runOnce<SkinService, SkinCanvasArrays>(
    startWorker(),
    (service) => service.makeCanvas(mesh, size, scale),
    workerError,
  )
  return canvasFromArrays(mesh, arrays)
}

function startWorker(): Worker {
  return new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' })
}

function workerError(reason: string | undefined): FurrowError {
  return new FurrowError({
    code: 'unsupported',
    who: 'Studio',
    problem: 'the worker that reads the skin has ended',
    value: reason,
    remedy: 'close other pages to free memory',
  })
}
