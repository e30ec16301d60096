import { FurrowError } from 'furrow'
import type { Skin } from 'furrow/author'
import { runOnce } from '../workers/run-once.ts'
import type { MadeSkin } from './make-skin.ts'
import type { SkinService } from './worker.ts'

/**
 * `makeSkin` in a worker of its own. The skin is copied.
 *
 * @returns a promise that rejects with an Error with the message of what `makeSkin` throws, and a FurrowError where the worker dies.
 */
export function makeSkinInWorker(skin: Skin, scale: number, size: number): Promise<MadeSkin> {
  const worker = new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' })
  return runOnce<SkinService, MadeSkin>(worker, (service) => service.makeSkin(skin, scale, size), died)
}

function died(reason: string | undefined): FurrowError {
  return new FurrowError({
    code: 'unsupported',
    who: 'Studio',
    what: 'the worker that reads the skin has ended',
    value: reason,
    remedy: 'close other pages to free memory',
  })
}
