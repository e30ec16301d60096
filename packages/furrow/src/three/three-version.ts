import { REVISION } from 'three'
import { FurrowError } from '../core/error.ts'

/** Releases of three.js that the GPU tests run on; `peerDependencies` starts at the oldest. */
export const TESTED_THREE = { oldest: 186, newest: 187 } as const

/**
 * Checks that three.js is recent enough for the nodes of `WebGPURenderer`: an older one fails to build the shader, and the mesh vanishes.
 *
 * @param who names the caller in the error.
 * @throws FurrowError when it is older than `TESTED_THREE`.
 */
export function checkThree(who: string): void {
  if (Number.parseInt(REVISION, 10) < TESTED_THREE.oldest) throw unsupported(who, 'three.js is too old')
}

/**
 * Guards what Furrow uses of three.js without it being documented there, so that a release that drops it is named.
 *
 * @param name of the internal, as three.js's sources have it.
 * @returns the value itself.
 * @throws FurrowError when it is undefined or null.
 */
export function requireInternal<T>(value: T | null | undefined, who: string, name: string): T {
  if (value === undefined || value === null) throw unsupported(who, `three.js lacks ${name}`)
  return value
}

function unsupported(who: string, what: string): FurrowError {
  return new FurrowError({
    code: 'unsupported',
    who,
    what,
    value: `r${REVISION}`,
    limit: `r${TESTED_THREE.oldest} to r${TESTED_THREE.newest}`,
    remedy: 'install a release of three.js in that range',
  })
}
