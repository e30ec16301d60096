import { FurrowError } from '../../core/error.ts'

/**
 * What was thrown while a file was read, as the error that users see: engines and browsers have words of their own.
 *
 * @param who, what of the error; a `FurrowError` remains as it is.
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
