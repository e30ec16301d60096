import { FurrowError } from '../../core/error.ts'

/** Error for an update of maps or areas in KTX 2 textures. */
export function compressed(who: string): FurrowError {
  return new FurrowError({
    code: 'unsupported',
    who,
    problem: 'textures of KTX 2 files cannot be changed',
    remedy: 'use a file with PNG or WebP maps',
  })
}
