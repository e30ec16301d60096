import { cos } from '../../../math/elementary.ts'
import { GridFft, type PeriodicGrid } from './grid-fft.ts'
import { splineCurvatures, splineSlopes, splineWeights } from './spline-weights.ts'

/** Height, slope and curvature of a relief at a position. */
export interface ReliefPoint {
  height: number
  /** Gradient. */
  x: number
  y: number
  /** Second derivatives. */
  xx: number
  xy: number
  yy: number
}

/** Heights on a periodic grid, interpolated by a cubic B-spline: twice continuously differentiable. */
export class Relief {
  readonly grid: PeriodicGrid
  readonly heights: Float64Array
  readonly #coefficients: Float64Array
  readonly #rows = weightsOfAxis()
  readonly #columns = weightsOfAxis()

  /** @param heights height of each sample in millimetres, row by row. The array is not copied. */
  constructor(grid: PeriodicGrid, heights: Float64Array) {
    this.grid = grid
    this.heights = heights
    this.#coefficients = splineCoefficients(grid, heights)
  }

  /** Returns the relief at a position in millimetres from the first sample. */
  at(x: number, y: number): ReliefPoint {
    const { width, height, spacing } = this.grid
    const [left, top] = [Math.floor(x / spacing), Math.floor(y / spacing)]
    const [columns, rows] = [this.#columns, this.#rows]
    setWeights(columns, x / spacing - left)
    setWeights(rows, y / spacing - top)
    const out: ReliefPoint = { height: 0, x: 0, y: 0, xx: 0, xy: 0, yy: 0 }
    for (let j = 0; j < 4; j++) {
      const row = modulo(top + j - 1, height) * width
      for (let i = 0; i < 4; i++) {
        const value = this.#coefficients[row + modulo(left + i - 1, width)]
        out.height += value * columns.value[i] * rows.value[j]
        out.x += value * columns.slope[i] * rows.value[j]
        out.y += value * columns.value[i] * rows.slope[j]
        out.xx += value * columns.curvature[i] * rows.value[j]
        out.xy += value * columns.slope[i] * rows.slope[j]
        out.yy += value * columns.value[i] * rows.curvature[j]
      }
    }
    out.x /= spacing
    out.y /= spacing
    out.xx /= spacing * spacing
    out.xy /= spacing * spacing
    out.yy /= spacing * spacing
    return out
  }
}

function weightsOfAxis() {
  return { value: new Float64Array(4), slope: new Float64Array(4), curvature: new Float64Array(4) }
}

function setWeights({ value, slope, curvature }: ReturnType<typeof weightsOfAxis>, t: number): void {
  splineWeights(value, t)
  splineSlopes(slope, t)
  splineCurvatures(curvature, t)
}

/** Computes the coefficients of the B-spline through all heights. Divides the spectrum of the heights by that of the basis function. */
function splineCoefficients(grid: PeriodicGrid, heights: Float64Array): Float64Array {
  const { width, height } = grid
  const fft = new GridFft(grid)
  const [re, im] = [heights.slice(), new Float64Array(heights.length)]
  fft.forward(re, im)
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const factor = 1 / (basisSpectrum(x / width) * basisSpectrum(y / height))
      re[y * width + x] *= factor
      im[y * width + x] *= factor
    }
  }
  fft.inverse(re, im)
  return re
}

/** Returns the spectrum of the cubic B-spline basis function, whose values at the samples are 1/6, 4/6 and 1/6. */
function basisSpectrum(turns: number): number {
  return (2 + cos(2 * Math.PI * turns)) / 3
}

function modulo(i: number, count: number): number {
  return i - count * Math.floor(i / count)
}
