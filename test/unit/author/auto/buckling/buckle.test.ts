import { createHash } from 'node:crypto'
import { describe, expect, test } from 'vitest'
import { buckle } from '../../../../../packages/furrow/src/author/auto/buckling/buckle.ts'
import {
  CRITICAL_COMPRESSION,
  filmWavelength,
} from '../../../../../packages/furrow/src/author/auto/buckling/film.ts'
import { GridFft, waveNumbers } from '../../../../../packages/furrow/src/author/auto/buckling/grid-fft.ts'
import type { Valley } from '../../../../../packages/furrow/src/author/auto/buckling/valleys.ts'
import { FILM_SIDE, squareFilm, valleysOf } from './films.ts'

describe('a square film that is compressed evenly', () => {
  test.each([
    [0.6, 0],
    [0.86, 90],
    [1.17, 30],
  ])('of %s mm has the wavelength of theory within 15%% at %s degrees', (thickness, degrees) => {
    const wavelength = filmWavelength(thickness)
    const film = squareFilm(wavelength, 0.12, { degrees })
    expect(Math.abs(meanWavelength(film.grid, buckle(film)) / wavelength - 1)).toBeLessThan(0.15)
  })

  test.each([0, 30, 75, 90])('folds across the compression at %d degrees', (degrees) => {
    const film = squareFilm(10, 0.12, { degrees })
    const valleys = valleysOf(film, buckle(film))
    expect(lengthOf(valleys)).toBeGreaterThan(0.6 * (FILM_SIDE * (FILM_SIDE / 10)))
    expect(meanTurn(valleys, degrees)).toBeLessThan(8)
  })

  test('has no lines below the critical compression, and lines above it', () => {
    const count = (factor: number) => {
      const film = squareFilm(10, factor * CRITICAL_COMPRESSION)
      return valleysOf(film, buckle(film)).length
    }
    expect(count(0.9)).toBe(0)
    expect(count(1.6)).toBeGreaterThan(5)
  })

  test('has lines only where it is compressed', () => {
    const film = squareFilm(10, 0.15, { weight: (x) => (x > 24 && x < 72 ? 1 : 0) })
    const valleys = valleysOf(film, buckle(film))
    expect(valleys.length).toBeGreaterThan(3)
    for (const { points } of valleys)
      for (let i = 0; i < points.length; i += 2) {
        expect(points[i]).toBeGreaterThan(24 - 5)
        expect(points[i]).toBeLessThan(72 + 5)
      }
  })

  test('has the same bytes for the same seed, and other lines for another seed', () => {
    const heights = (seed: number) => buckle(squareFilm(10, 0.12, { seed }))
    const first = heights(1)
    expect(sha256(first)).toBe(HASH)
    expect(sha256(heights(1))).toBe(HASH)
    const film = squareFilm(10, 0.12)
    const [a, b] = [valleysOf(film, first), valleysOf(film, heights(2))]
    expect(sharedLength(a, b, 1.5)).toBeLessThan(0.6)
  })
})

test('half the grid spacing moves no line by more than 1.5 mm', () => {
  const bump = (x: number, y: number) =>
    Math.exp(-(((x - FILM_SIDE / 2) / 26) ** 2) - ((y - FILM_SIDE / 2) / 16) ** 2)
  const [coarse, fine] = [1.5, 0.75].map((spacing) => {
    const film = squareFilm(10, 0.2, { degrees: 80, spacing, weight: bump })
    return valleysOf(film, buckle(film))
  })
  expect(coarse.length).toBeGreaterThan(2)
  expect(sharedLength(coarse, fine, 1.5)).toBe(1)
  expect(sharedLength(fine, coarse, 1.5)).toBe(1)
})

test('an error thrown by the progress report ends the work', () => {
  let reports = 0
  const cancelled = new Error('cancelled')
  const run = () =>
    buckle(squareFilm(10, 0.12), (fraction) => {
      expect(fraction).toBeGreaterThanOrEqual(0)
      expect(fraction).toBeLessThan(1)
      if (++reports === 3) throw cancelled
    })
  expect(run).toThrow(cancelled)
  expect(reports).toBe(3)
})

test('the transform finds a wave, and its inverse restores it', () => {
  const grid = { width: 16, height: 8, spacing: 2 }
  const fft = new GridFft(grid)
  const wave = Float64Array.from({ length: 128 }, (_, i) => Math.cos((2 * Math.PI * 3 * (i % 16)) / 16))
  const [re, im] = [wave.slice(), new Float64Array(128)]
  fft.forward(re, im)
  for (let i = 0; i < 128; i++) expect(re[i]).toBeCloseTo(i === 3 || i === 13 ? 64 : 0, 9)
  expect(waveNumbers(16, 2)[13]).toBeCloseTo((-2 * Math.PI * 3) / 32, 12)
  fft.inverse(re, im)
  for (let i = 0; i < 128; i++) expect(re[i]).toBeCloseTo(wave[i], 12)
})

const HASH = '44beff152c74d58797737a38e619eda07c2ef09c2357bce749eb96675ea3c0a8'

function sha256(values: Float64Array): string {
  return createHash('sha256').update(new Uint8Array(values.buffer)).digest('hex')
}

/** Returns the wavelength of the mean square wave number. */
function meanWavelength(grid: { width: number; height: number; spacing: number }, heights: Float64Array) {
  const [re, im] = [heights.slice(), new Float64Array(heights.length)]
  new GridFft(grid).forward(re, im)
  const [kx, ky] = [waveNumbers(grid.width, grid.spacing), waveNumbers(grid.height, grid.spacing)]
  let [sum, power] = [0, 0]
  for (let i = 0; i < re.length; i++) {
    const square = re[i] ** 2 + im[i] ** 2
    power += square
    sum += square * (kx[i % grid.width] ** 2 + ky[Math.floor(i / grid.width)] ** 2)
  }
  return (2 * Math.PI) / Math.sqrt(sum / power)
}

function lengthOf(valleys: readonly Valley[]): number {
  return valleys.reduce((sum, { points }) => sum + 0.6 * (points.length / 2 - 1), 0)
}

/** Returns the mean angle in degrees between lines and the normal of the compression. */
function meanTurn(valleys: readonly Valley[], degrees: number): number {
  let [sum, count] = [0, 0]
  for (const { points } of valleys) {
    for (let i = 0; i + 3 < points.length; i += 2) {
      const angle =
        (Math.atan2(points[i + 3] - points[i + 1], points[i + 2] - points[i]) * 180) / Math.PI - degrees - 90
      sum += Math.abs(angle - 180 * Math.round(angle / 180))
      count++
    }
  }
  return sum / count
}

/** Returns the fraction of the points of `lines` that are within a distance of `others`. */
function sharedLength(lines: readonly Valley[], others: readonly Valley[], distance: number): number {
  const near = (x: number, y: number) =>
    others.some(({ points }) =>
      points.some((_, i) => i % 2 === 0 && Math.hypot(points[i] - x, points[i + 1] - y) <= distance),
    )
  let [shared, count] = [0, 0]
  for (const { points } of lines) {
    for (let i = 0; i < points.length; i += 2) {
      count++
      if (near(points[i], points[i + 1])) shared++
    }
  }
  return shared / count
}
