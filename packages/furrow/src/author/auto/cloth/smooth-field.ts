import { exp } from '../../../math/elementary.ts'
import { GridFft, type PeriodicGrid, waveNumbers } from '../buckling/grid-fft.ts'

/** Returns a function that smooths fields on a grid with a Gaussian. */
export function fieldSmoother(grid: PeriodicGrid, sigma: number): (field: ArrayLike<number>) => Float64Array {
  const { width, height, spacing } = grid
  const fft = new GridFft(grid)
  const [kx, ky] = [waveNumbers(width, spacing), waveNumbers(height, spacing)]
  const factors = new Float64Array(width * height)
  for (let y = 0; y < height; y++)
    for (let x = 0; x < width; x++)
      factors[y * width + x] = exp(-0.5 * sigma * sigma * (kx[x] * kx[x] + ky[y] * ky[y]))
  return (field) => {
    const [re, im] = [Float64Array.from(field), new Float64Array(field.length)]
    fft.forward(re, im)
    for (let i = 0; i < re.length; i++) {
      re[i] *= factors[i]
      im[i] *= factors[i]
    }
    fft.inverse(re, im)
    return re
  }
}
