import { FurrowError } from './error.ts'

/**
 * Creates the error for an invalid argument.
 *
 * @param argument name of the argument, without an article.
 */
export function wrongArgument(who: string, argument: string, value: unknown, limit: string): FurrowError {
  return new FurrowError({
    who,
    problem: `invalid ${argument}`,
    value: value ?? String(value),
    limit,
    remedy: 'correct the argument',
  })
}

/** Whether a value is a non-null object. */
export function isObject(value: unknown): value is object {
  return typeof value === 'object' && value !== null
}

/** @throws FurrowError if the value is NaN or infinite; undefined is allowed. */
export function checkFinite(value: number | undefined, argument: string, who: string): void {
  if (value !== undefined && !Number.isFinite(value))
    throw wrongArgument(who, argument, value, 'a finite number')
}
