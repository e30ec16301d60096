import { exp } from '../../../math/elementary.ts'
import type { FilmNoise } from './film-noise.ts'
import { GridFft, type PeriodicGrid, waveNumbers } from './grid-fft.ts'

/** Stiff film on a soft base, with the compression that an expression imposes on it. Fields have one value per sample of the grid. */
export interface Film {
  grid: PeriodicGrid
  /** Position of the first sample, in millimetres. The random irregularities of the film depend on the position. */
  origin: readonly [x: number, y: number]
  /** Fraction of length that the film loses: components xx, xy, yy of a symmetric tensor. Negative where the film is stretched. */
  compression: readonly [xx: Float64Array, xy: Float64Array, yy: Float64Array]
  /** Distance between wrinkles in millimetres. */
  wavelength: Float64Array
  /** Compression at which the film buckles. */
  critical: Float64Array
  /** Irregularities of the film. */
  noise: FilmNoise
}

/** Time step, dimensionless. */
const TIME_STEP = 0.2
/** Number of steps over which the compression grows to its full value. */
const RAMP_STEPS = 200
/** Number of steps at the full compression. */
const HOLD_STEPS = 40
/** The released compression (the part that wrinkles have taken up) changes slowly. It is updated once in this number of steps. */
const RELEASE_STEPS = 2
/** Standard deviation, in wavelengths, of the Gaussian that smooths the released compression. */
const RELEASE_SIGMA = 0.4
/** Coefficient of the quadratic term, per millimetre. The term makes valleys sharp and ridges round. */
const SHARPNESS = 0.25
/** Coefficient of the cubic term, per square millimetre. The term limits the heights. */
const SATURATION = 0.06
/** Amplitude of the initial noise, in millimetres. */
const FIRST_HEIGHT = 0.01
/** Size of the bumps in the initial noise, in wavelengths. */
const FIRST_SIZE = 0.2
/** Amplitude of the constant noise force f in the equation of `buckle`, in millimetres. */
const LASTING_FORCE = 0.02
/** Size of the bumps in the noise force, in millimetres. */
const LASTING_SIZE = 1.5
/** Minimum coefficient of the stabilising diffusion. */
const MIN_STABILISER = 3
/** Ratio of the stabilising terms to those that stability needs at least: half of the largest explicit linear terms. */
const STABILISER = 1.3
/** Number of steps between progress reports. */
const REPORT_STEPS = 20

/**
 * Computes the wrinkles of a compressed film. Solves an anisotropic Swift-Hohenberg equation, to which the Foeppl-von Karman equations reduce
 * near the onset of buckling:
 *
 *     k0^4 w_t = -(lap^2 + k^4) w - 2 d_i [k^2 / e (C_ij - <w_i w_j> / 2) d_j w] + k0^4 (f - q w^2 / 2 - p w^3)
 *
 * Here, w is the height, t the time, C the compression and e the critical compression. The noise force is f. C and f grow from 0 to their full
 * values. The local wavelength has the wave number k, and the mean wavelength has k0. The factor q is `SHARPNESS`, and p is `SATURATION`.
 * Angle brackets denote smoothing with `RELEASE_SIGMA`.
 *
 * Steps are semi-implicit in Fourier space (Chen, Shen 1998, Applications of semi-implicit Fourier-spectral method to phase field
 * equations). Only + - * / and sqrt are used, so all JavaScript engines give the same bits.
 *
 * @param report called with the fraction done; may throw to cancel.
 * @returns heights in millimetres, with mean 0.
 */
export function buckle(film: Film, report: (fraction: number) => void = () => {}): Float64Array {
  const solver = new Solver(film)
  const steps = RAMP_STEPS + HOLD_STEPS
  for (let step = 0; step < steps; step++) {
    if (step % REPORT_STEPS === 0) report(step / steps)
    solver.step(Math.min(1, (step + 1) / RAMP_STEPS), step % RELEASE_STEPS === 0)
  }
  return solver.heights
}

/** State of the equation, and its constant fields. */
class Solver {
  readonly heights: Float64Array
  readonly #film: Film
  readonly #fft: GridFft
  readonly #kx: Float64Array
  readonly #ky: Float64Array
  /** Spectrum of the heights. */
  readonly #re: Float64Array
  readonly #im: Float64Array
  /** Released compression: components xx, xy, yy. */
  readonly #released: readonly [Float64Array, Float64Array, Float64Array]
  /** Spectrum of the Gaussian that smooths `#released`. */
  readonly #smoothing: Float64Array
  /**
   * Coefficients of the stabilising terms, per component of the spectrum. A step adds these terms explicitly (for the heights at its start) and
   * subtracts them implicitly (for the heights at its end).
   */
  readonly #stabiliser: Float64Array
  /** Coefficients of the new heights in the implicit equation of a step, per component of the spectrum. */
  readonly #divisor: Float64Array
  /** Squared wave number of each component of the spectrum, divided by k0^2. */
  readonly #square: Float64Array
  /** k^2 / k0^2 per sample. */
  readonly #ratio: Float64Array
  /** Largest k^4 / k0^4 - 1; at least 0. */
  readonly #stiffest: number
  /** 2 k^2 / (e k0^4) per sample. */
  readonly #gain: Float64Array
  /** k^4 / k0^4 - 1 per sample. */
  readonly #stiffening: Float64Array
  /** Constant noise force per sample. */
  readonly #force: Float64Array
  /** Scratch: two complex fields. */
  readonly #a: readonly [Float64Array, Float64Array]
  readonly #b: readonly [Float64Array, Float64Array]

  constructor(film: Film) {
    const { grid, origin, wavelength, critical, noise } = film
    const { width, height, spacing } = grid
    const count = width * height
    const field = () => new Float64Array(count)
    this.#film = film
    this.#fft = new GridFft(grid)
    this.#kx = waveNumbers(width, spacing)
    this.#ky = waveNumbers(height, spacing)
    this.#released = [field(), field(), field()]
    this.#a = [field(), field()]
    this.#b = [field(), field()]
    const mean = wavelength.reduce((sum, value) => sum + value, 0) / count
    const k0 = (2 * Math.PI) / mean
    const release = 2 * Math.PI * RELEASE_SIGMA
    this.#ratio = wavelength.map((value) => mean / value).map((ratio) => ratio * ratio)
    this.#stiffest = this.#ratio.reduce((most, value) => Math.max(most, value * value - 1), 0)
    this.#smoothing = field()
    this.#stabiliser = field()
    this.#divisor = field()
    this.#square = field()
    this.#gain = field()
    this.#stiffening = field()
    this.#force = field()
    this.heights = field()
    for (let y = 0; y < height; y++) {
      for (let x = 0; x < width; x++) {
        const i = y * width + x
        const square = (this.#kx[x] * this.#kx[x] + this.#ky[y] * this.#ky[y]) / (k0 * k0)
        this.#square[i] = square
        this.#smoothing[i] = exp(-0.5 * square * (release * release))
        this.#gain[i] = (2 * this.#ratio[i]) / (critical[i] * k0 * k0)
        this.#stiffening[i] = this.#ratio[i] * this.#ratio[i] - 1
        const [px, py] = [origin[0] + x * spacing, origin[1] + y * spacing]
        this.#force[i] = LASTING_FORCE * noise(px, py, LASTING_SIZE, 0)
        this.heights[i] = FIRST_HEIGHT * noise(px, py, FIRST_SIZE * mean, 1)
      }
    }
    this.#re = this.heights.slice()
    this.#im = field()
    this.#fft.forward(this.#re, this.#im)
  }

  /** Updates the released compression, <w_i w_j> / 2, from the slopes. */
  #release(wx: Float64Array, wy: Float64Array): void {
    const [xx, xy, yy] = this.#released
    const [re, im] = this.#b
    for (let i = 0; i < wx.length; i++) {
      re[i] = 0.5 * wx[i] * wx[i]
      im[i] = 0.5 * wy[i] * wy[i]
      xy[i] = 0.5 * wx[i] * wy[i]
    }
    this.#smooth(re, im)
    xx.set(re)
    yy.set(im)
    im.fill(0)
    this.#smooth(xy, im)
    this.#stabilise()
  }

  /** Adapts the stabilising terms to the largest imposed, released or remaining (imposed minus released) compression. */
  #stabilise(): void {
    const { compression, critical } = this.#film
    const [cxx, cxy, cyy] = compression
    const [rxx, rxy, ryy] = this.#released
    let largest = MIN_STABILISER / STABILISER
    for (let i = 0; i < critical.length; i++) {
      const stress = Math.max(
        largestStress(cxx[i], rxx[i]),
        largestStress(cxy[i], rxy[i]),
        largestStress(cyy[i], ryy[i]),
      )
      largest = Math.max(largest, (this.#ratio[i] * stress) / critical[i])
    }
    for (let i = 0; i < this.#square.length; i++) {
      const square = this.#square[i]
      this.#stabiliser[i] = STABILISER * (largest * square + this.#stiffest / 2)
      this.#divisor[i] = 1 + TIME_STEP * (square * square + 1 + this.#stabiliser[i])
    }
  }

  /**
   * @param ramp fraction of the compression that is imposed, 0..1.
   * @param isReleasing whether to update the released compression first.
   */
  step(ramp: number, isReleasing: boolean): void {
    const [cxx, cxy, cyy] = this.#film.compression
    const [rxx, rxy, ryy] = this.#released
    const [wx, wy] = this.#slopes()
    if (isReleasing) this.#release(wx, wy)
    const [re, im] = this.#b
    const w = this.heights
    for (let i = 0; i < w.length; i++) {
      const x = wx[i]
      const y = wy[i]
      const xx = ramp * cxx[i] - rxx[i]
      const xy = ramp * cxy[i] - rxy[i]
      const yy = ramp * cyy[i] - ryy[i]
      wx[i] = this.#gain[i] * (xx * x + xy * y)
      wy[i] = this.#gain[i] * (xy * x + yy * y)
      const square = w[i] * w[i]
      re[i] =
        ramp * this.#force[i] -
        this.#stiffening[i] * w[i] -
        (SHARPNESS / 2) * square -
        SATURATION * square * w[i]
      im[i] = 0
    }
    this.#fft.forward(wx, wy)
    this.#fft.forward(re, im)
    this.#advance()
    w.set(this.#re)
    im.set(this.#im)
    this.#fft.inverse(w, im)
  }

  /** Advances the spectrum of the heights by one step. The x and y components of the flux share a complex transform, and are separated here. */
  #advance(): void {
    const { width, height } = this.#film.grid
    const [fluxRe, fluxIm] = this.#a
    const [restRe, restIm] = this.#b
    for (let y = 0; y < height; y++) {
      const mirroredRow = ((height - y) % height) * width
      const ky = this.#ky[y]
      for (let x = 0; x < width; x++) {
        const i = y * width + x
        const j = mirroredRow + (x === 0 ? 0 : width - x)
        const kx = this.#kx[x]
        const xRe = 0.5 * (fluxRe[i] + fluxRe[j])
        const xIm = 0.5 * (fluxIm[i] - fluxIm[j])
        const yRe = 0.5 * (fluxIm[i] + fluxIm[j])
        const yIm = -0.5 * (fluxRe[i] - fluxRe[j])
        const re = kx * xIm + ky * yIm + restRe[i] + this.#stabiliser[i] * this.#re[i]
        const im = -kx * xRe - ky * yRe + restIm[i] + this.#stabiliser[i] * this.#im[i]
        this.#re[i] = (this.#re[i] + TIME_STEP * re) / this.#divisor[i]
        this.#im[i] = (this.#im[i] + TIME_STEP * im) / this.#divisor[i]
      }
    }
    this.#re[0] = 0
    this.#im[0] = 0
  }

  /** Returns the slopes in x and y: the real and the imaginary part of one inverse transform. The first scratch field receives them. */
  #slopes(): readonly [Float64Array, Float64Array] {
    const { width, height } = this.#film.grid
    const [re, im] = this.#a
    for (let y = 0; y < height; y++) {
      // The wave with the highest wave number is left out, because the spectrum of its slope is not that of a real field.
      const ky = 2 * y === height ? 0 : this.#ky[y]
      for (let x = 0; x < width; x++) {
        const i = y * width + x
        const kx = 2 * x === width ? 0 : this.#kx[x]
        re[i] = -kx * this.#im[i] - ky * this.#re[i]
        im[i] = kx * this.#re[i] - ky * this.#im[i]
      }
    }
    this.#fft.inverse(re, im)
    return this.#a
  }

  #smooth(re: Float64Array, im: Float64Array): void {
    this.#fft.forward(re, im)
    for (let i = 0; i < re.length; i++) {
      re[i] *= this.#smoothing[i]
      im[i] *= this.#smoothing[i]
    }
    this.#fft.inverse(re, im)
  }
}

/** Returns the largest of the imposed, remaining and released compression. */
function largestStress(imposed: number, released: number): number {
  return Math.max(Math.abs(imposed), Math.abs(imposed - released), Math.abs(released))
}
