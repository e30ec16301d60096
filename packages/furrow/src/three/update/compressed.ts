import { FurrowError } from '../../core/error.ts'

export function compressed(who: string): FurrowError {
  return new FurrowError({
    code: 'unsupported',
    who,
    problem: 'textures of KTX 2 files cannot be changed',
    remedy: 'use a file with PNG or WebP maps',
  })
}
