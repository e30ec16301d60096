import { FurrowError } from '../../core/error.ts'

/**
 * Converts an error that an engine or browser threw while reading a file to a `FurrowError` with parts `who` and `problem`. Returns a
 * `FurrowError` unchanged.
 */
export function fileError(thrown: unknown, who: string, problem: string): FurrowError {
  if (thrown instanceof FurrowError) return thrown
  return new FurrowError({
    code: 'unreadable',
    who,
    problem,
    value: thrown instanceof Error ? thrown.message : thrown,
    remedy: 'check the file with `npx furrow validate`',
  })
}
