import { FurrowError } from '../core/error.ts'

/** Releases of three.js that the GPU tests run on; `peerDependencies` starts at the oldest. */
export const TESTED_THREE = { oldest: 186, newest: 187 } as const

/**
 * Checks that three.js is recent enough for the nodes of `WebGPURenderer`: an older one fails to build the shader, and the mesh vanishes.
 *
 * @param who names the caller in the error.
 * @param revision three.js's `REVISION`. This module does not import three.js: see `scripts/join-modules.mjs`.
 * @throws FurrowError when it is older than `TESTED_THREE`.
 */
export function checkThree(who: string, revision: string): void {
  if (Number.parseInt(revision, 10) < TESTED_THREE.oldest)
    throw unsupported(who, 'three.js is too old', revision)
}

/**
 * Guards what Furrow uses of three.js without it being documented there, so that a release that drops it is named.
 *
 * @param name of the internal, as three.js's sources have it.
 * @param revision as `checkThree` has it.
 * @returns the value itself.
 * @throws FurrowError when it is undefined or null.
 */
export function requireInternal<T>(
  value: T | null | undefined,
  who: string,
  name: string,
  revision: string,
): T {
  if (value === undefined || value === null) throw unsupported(who, `three.js lacks ${name}`, revision)
  return value
}

function unsupported(who: string, what: string, revision: string): FurrowError {
  return new FurrowError({
    code: 'unsupported',
    who,
    what,
    value: `r${revision}`,
    limit: `r${TESTED_THREE.oldest} to r${TESTED_THREE.newest}`,
    remedy: 'install a release of three.js in that range',
  })
}
