import { FurrowError } from '../core/error.ts'
import type { Entry } from './renderer.ts'

/** The oldest release of three.js that each entry supports; `peerDependencies` starts at the older one. */
export const OLDEST_THREE = { 'furrow/three': 160, 'furrow/webgpu': 186 } as const

/** The newest release of three.js that the tests run on. */
export const NEWEST_THREE = 187

/** The number of a release, from three.js's `REVISION`: 187 of `187dev`. */
export function releaseOf(revision: string): number {
  return Number.parseInt(revision, 10)
}

/**
 * Checks that three.js is recent enough for an entry: shaders of an older one do not compile, and the mesh vanishes.
 *
 * @param revision three.js's `REVISION`.
 * @throws FurrowError when it is older than `OLDEST_THREE`.
 */
export function checkThree(entry: Entry, revision: string): void {
  const oldest = OLDEST_THREE[entry]
  if (releaseOf(revision) < oldest) {
    throw new FurrowError({
      code: 'unsupported',
      who: `Wrinkles of ${entry}`,
      problem: 'three.js is too old',
      value: `r${releaseOf(revision)}`,
      limit: `r${oldest} or later`,
      remedy: `npm install three@^0.${oldest}.0, or a later release`,
    })
  }
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
  if (value !== undefined && value !== null) return value
  throw new FurrowError({
    code: 'unsupported',
    who,
    problem: `three.js lacks ${name}`,
    value: `r${revision}`,
    limit: `up to r${NEWEST_THREE}`,
    remedy: 'install a release of three.js that Furrow is tested with',
  })
}
