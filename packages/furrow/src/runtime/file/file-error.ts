import { FurrowError } from '../../core/error.ts'

/**
 * Converts an error thrown while reading a file to a `FurrowError`, because messages of engines and browsers vary. Returns a
 * `FurrowError` unchanged.
 *
 * @param who, problem parts of the new error.
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
