import { transfer } from 'comlink'
import { FurrowError } from 'furrow'
import type { Skin, SkinCanvas } from 'furrow/author'
import { buffersOf, canvasAgain, type SkinCanvasArrays } from 'furrow/internal'
import { runOnce } from '../workers/run-once.ts'
import type { MadeSkin } from './make-skin.ts'
import type { SkinService } from './worker.ts'

/**
 * `makeSkin` in a worker of its own. The arrays of the skin are moved there and come back with what was made: copying them would take the page
 * as long as reading them.
 *
 * @returns a promise that rejects with an Error with the message of what `makeSkin` throws, and a FurrowError where the worker dies.
 */
export function makeSkinInWorker(
  skin: Skin,
  scale: number,
  size: number,
): Promise<{ skin: Skin; made: MadeSkin }> {
  const moved = transfer(skin, buffersOf(skin))
  return runOnce<SkinService, { skin: Skin; made: MadeSkin }>(
    startWorker(),
    (service) => service.makeSkin(moved, scale, size),
    died,
  )
}

/** `skinCanvas` in a worker of its own. It rejects as `makeSkinInWorker` does. */
export async function makeCanvasInWorker(
  mesh: Pick<Skin, 'positions' | 'uvs' | 'indices'>,
  size: number,
  scale: number,
): Promise<SkinCanvas> {
  const arrays = await runOnce<SkinService, SkinCanvasArrays>(
    startWorker(),
    (service) => service.makeCanvas(mesh, size, scale),
    died,
  )
  return canvasAgain(mesh, arrays)
}

function startWorker(): Worker {
  return new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' })
}

function died(reason: string | undefined): FurrowError {
  return new FurrowError({
    code: 'unsupported',
    who: 'Studio',
    problem: 'the worker that reads the skin has ended',
    value: reason,
    remedy: 'close other pages to free memory',
  })
}
