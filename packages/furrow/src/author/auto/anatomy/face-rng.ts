import { blendUniform } from '../../../math/random-blend.ts'
import { Rng } from '../../../math/rng.ts'
import { lerp } from '../../../math/scalar.ts'
import { type FilmNoise, filmNoise, foldedNoise, mirroredNoise } from '../buckling/film-noise.ts'

/**
 * Random number generator for one part of the face. At symmetry 0, each part has its own numbers. At symmetry 1, a part on the person's right
 * has the numbers of the part on the left that it mirrors, and a part that crosses the middle is symmetric.
 */
export class FaceRng {
  readonly #own: Rng
  /** Numbers of the part on the left that this part mirrors; `middle` for a part that crosses the middle of the face. */
  readonly #mirrored: Rng | 'middle' | undefined
  readonly #symmetry: number

  private constructor(own: Rng, symmetry: number, mirrored?: Rng | 'middle') {
    this.#own = own
    this.#mirrored = symmetry > 0 ? mirrored : undefined
    this.#symmetry = symmetry
  }

  /**
   * Creates the generator of a part.
   *
   * @param name name of the part. Parts on one side of the face end in `Left` or `Right`.
   * @param symmetry 0..1.
   */
  static of(seed: number, name: string, symmetry: number): FaceRng {
    const own = new Rng(seed, name)
    if (name.endsWith('Left')) return new FaceRng(own, symmetry)
    const left = name.replace(/Right$/, 'Left')
    return new FaceRng(own, symmetry, left === name ? 'middle' : new Rng(seed, left))
  }

  /** Returns a uniformly distributed number between two bounds. */
  uniform(low: number, high: number): number {
    return low + (high - low) * this.#next(false)
  }

  /** Returns a uniformly distributed number between `-amplitude` and `amplitude`. */
  jitter(amplitude: number): number {
    return this.uniform(-amplitude, amplitude)
  }

  /**
   * Returns a random number between `-amplitude` and `amplitude`. At symmetry 1, mirrored lines get opposite numbers, and a line in the middle
   * gets 0. Use it for distances across the face and for slopes, in parts that cross the middle.
   */
  across(amplitude: number): number {
    return -amplitude + 2 * amplitude * this.#next(true)
  }

  /** Returns random irregularities for a part of the skin that buckles, see `SkinFilm.noise`. */
  film(): FilmNoise {
    const own = filmNoise(this.#own.integer())
    if (!this.#mirrored) return own
    if (this.#mirrored === 'middle') return foldedNoise(own, this.#symmetry)
    return mirroredNoise(own, filmNoise(this.#mirrored.integer()), this.#symmetry)
  }

  /**
   * Draws the lines of a part that crosses the middle of the face.
   *
   * @param draw draws one line with the generator that it gets. Each line must take the same count of numbers.
   * @param mirroredOf takes the index of a line. For a line on the right, returns the index of the line on the left that it mirrors. For a line
   *   in the middle, returns the same index. For a line on the left, returns undefined. Default: lines are ordered from the person's right to left.
   */
  row<Line>(
    count: number,
    draw: (rng: FaceRng, index: number) => Line,
    mirroredOf = (i: number): number | undefined => (2 * i < count ? count - 1 - i : undefined),
  ): Line[] {
    // A line on the right can need the numbers of a later line. So all lines are drawn once, only to find where the numbers of each line start.
    const starts = Array.from({ length: count }, (_, i) => {
      const start = this.#own.copy()
      draw(new FaceRng(this.#own, 0), i)
      return start
    })
    return starts.map((start, i) => {
      const mirrored = mirroredOf(i)
      const other = mirrored === i ? 'middle' : mirrored === undefined ? undefined : starts[mirrored].copy()
      return draw(new FaceRng(start.copy(), this.#symmetry, other), i)
    })
  }

  /** Interpolates, by symmetry, from the value of a part on the right to the value of the part on the left that it mirrors. */
  towards(left: number, own: number): number {
    return lerp(own, left, this.#symmetry)
  }

  #next(isAcross: boolean): number {
    const own = this.#own.next()
    if (!this.#mirrored) return own
    if (this.#mirrored === 'middle') return isAcross ? lerp(own, 0.5, this.#symmetry) : own
    const other = this.#mirrored.next()
    return blendUniform(own, isAcross ? 1 - other : other, this.#symmetry)
  }
}
