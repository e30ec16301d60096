import type { Film } from '../../../../../packages/furrow/src/author/auto/buckling/buckle.ts'
import { CRITICAL_COMPRESSION } from '../../../../../packages/furrow/src/author/auto/buckling/film.ts'
import { filmNoise } from '../../../../../packages/furrow/src/author/auto/buckling/film-noise.ts'
import { Relief } from '../../../../../packages/furrow/src/author/auto/buckling/relief.ts'
import { traceValleys, type Valley } from '../../../../../packages/furrow/src/author/auto/buckling/valleys.ts'

/** Side of a square film in millimetres. */
export const FILM_SIDE = 96

/** Creates a square film of even stiffness, compressed in one direction. */
export function squareFilm(
  wavelength: number,
  compression: number,
  { degrees = 0, spacing = 1.5, seed = 1, weight = (_x: number, _y: number): number => 1 } = {},
): Film {
  const side = FILM_SIDE / spacing
  const [c, s] = [Math.cos((degrees * Math.PI) / 180), Math.sin((degrees * Math.PI) / 180)]
  const weights = Float64Array.from({ length: side * side }, (_, i) =>
    weight((i % side) * spacing, Math.floor(i / side) * spacing),
  )
  const part = (factor: number) => weights.map((value) => value * compression * factor)
  return {
    grid: { width: side, height: side, spacing },
    origin: [0, 0],
    compression: [part(c * c), part(c * s), part(s * s)],
    wavelength: weights.map(() => wavelength),
    critical: weights.map(() => CRITICAL_COMPRESSION),
    noise: filmNoise(seed),
  }
}

/** Traces the valleys of a square film. */
export function valleysOf(film: Film, heights: Float64Array): Valley[] {
  return traceValleys(new Relief(film.grid, heights), {
    step: 0.6,
    wavelength: () => film.wavelength[0],
    isInside: (x, y) => x >= 0 && y >= 0 && x < FILM_SIDE && y < FILM_SIDE,
    minDepth: 0.1,
    minLength: 7,
  })
}
