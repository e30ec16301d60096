import { FurrowError } from 'furrow'

/** Throws FurrowError if a number is not finite or outside a range. Accepts undefined. */
export function checkRange(problem: string, value: number | undefined, low: number, high: number): void {
  if (value === undefined || (value >= low && value <= high)) return
  throw new FurrowError({
    code: 'out-of-range',
    who: 'Studio',
    problem,
    value,
    limit: `${low} to ${high}`,
    remedy: 'choose one in this range',
  })
}
