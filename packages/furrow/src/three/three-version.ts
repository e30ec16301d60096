import { FurrowError } from '../core/error.ts'
import type { Entry } from './renderer.ts'

/** Oldest three.js release that each entry point supports. The range in `peerDependencies` starts at the lower of the two numbers. */
export const OLDEST_THREE = { 'furrow/three': 160, 'furrow/webgpu': 186 } as const

/** Newest three.js release that the tests run on. */
export const NEWEST_THREE = 187

/** Returns the release number in three.js's `REVISION`, e.g. 187 for `187dev`. */
export function releaseOf(revision: string): number {
  return Number.parseInt(revision, 10)
}

/**
 * Checks that three.js is recent enough for an entry point. With older releases the shaders fail to compile and the mesh disappears.
 *
 * @param revision three.js's `REVISION`.
 * @throws FurrowError if the release is older than `OLDEST_THREE`.
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
 * Checks that an undocumented internal of three.js exists. Newer releases may remove it.
 *
 * @param name name of the internal in three.js's sources.
 * @param revision three.js's `REVISION`.
 * @returns `value`.
 * @throws FurrowError if `value` is undefined or null.
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
    remedy: 'install a three.js release that Furrow is tested with',
  })
}
