import { FurrowError } from 'furrow'

/** Throws FurrowError unless a value is undefined or within a range. */
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
