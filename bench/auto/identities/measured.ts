import type { ForeheadMovement } from './forehead.ts'
import type { SkinLine } from './skin-lines.ts'

export const AGES = [30, 50, 70] as const
export type Age = (typeof AGES)[number]
/** Age at which patterns are compared. */
export const COMPARED_AGE = 50 satisfies Age

/** Result of measure-identity.ts. */
export interface MeasuredIdentity {
  forehead: ForeheadMovement
  /** Patterns with the default seed. */
  byAge: Record<Age, Pattern>
  /** Pattern with another seed, at `COMPARED_AGE`. */
  reseeded: Pattern
  /** CPU time, in seconds, of a process that reads the file and makes the wrinkles with default settings. */
  seconds: number
  /** Peak memory of the same process. */
  megabytes: number
}

/** Lines of one face at one age. */
export interface Pattern {
  /** Number of lines of the forehead, see `countForeheadLines`. */
  foreheadLines: number
  /**
   * Distance between lines divided by the wavelength of the skin. The keys are regions: only those whose lines `autoWrinkles` computes from
   * the compression of skin.
   */
  spacings: Record<string, number>
  lines: MeasuredLine[]
}

export interface MeasuredLine extends Pick<SkinLine, 'region' | 'length'> {
  /** Texture coordinates at even distances. */
  uvs: (readonly [u: number, v: number])[]
}
