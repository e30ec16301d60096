import { FurrowError } from './error.ts'

/**
 * What a function throws that was called with something else than it takes.
 *
 * @param who the function, as its caller knows it.
 * @param what names the argument, or what is wrong with it.
 */
export function wrongArgument(who: string, problem: string, value: unknown, limit: string): FurrowError {
  return new FurrowError({ who, problem, value: value ?? String(value), limit, remedy: 'correct the call' })
}

/** Whether a value is an object, and not null. */
export function isObject(value: unknown): value is object {
  return typeof value === 'object' && value !== null
}

/** @throws FurrowError when a number is given that is not finite. */
export function checkFinite(value: number | undefined, problem: string, who: string): void {
  if (value !== undefined && !Number.isFinite(value))
    throw wrongArgument(who, problem, value, 'a finite number')
}
