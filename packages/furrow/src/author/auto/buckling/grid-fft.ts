import { cos, sin } from '../../../math/elementary.ts'

/** Rectangular grid of samples that repeats in both directions. */
export interface PeriodicGrid {
  /** Samples per row and per column; powers of two. */
  width: number
  height: number
  /** Distance between samples in millimetres. */
  spacing: number
}

/**
 * Discrete Fourier transform of complex fields on a grid, by Cooley and Tukey's radix-2 algorithm (1965). It uses only + - * /, also in the
 * polynomials that compute cosines and sines, so all JavaScript engines give the same bits.
 */
export class GridFft {
  readonly #width: number
  readonly #height: number
  readonly #rows: Butterflies
  readonly #columns: Butterflies

  constructor({ width, height }: PeriodicGrid) {
    this.#width = width
    this.#height = height
    this.#rows = new Butterflies(width)
    this.#columns = new Butterflies(height)
  }

  /** Transforms a field in place. */
  forward(re: Float64Array, im: Float64Array): void {
    this.#rows.run(re, im, 1)
    this.#columns.run(re, im, this.#width)
  }

  /** Inverts `forward` in place. */
  inverse(re: Float64Array, im: Float64Array): void {
    // Swapping the real and the imaginary part, before and after a forward transform, yields the inverse transform without its scale.
    this.forward(im, re)
    const scale = 1 / (this.#width * this.#height)
    for (let i = 0; i < re.length; i++) {
      re[i] *= scale
      im[i] *= scale
    }
  }
}

/** Wave numbers of the samples of a transform, in radians per millimetre. */
export function waveNumbers(count: number, spacing: number): Float64Array {
  const step = (2 * Math.PI) / (count * spacing)
  return Float64Array.from({ length: count }, (_, i) => step * (i < count / 2 ? i : i - count))
}

/** One-dimensional transform of a fixed length. */
class Butterflies {
  readonly #count: number
  /** Pairs of elements to swap, so that the elements are in bit-reversed order. */
  readonly #swaps: Uint32Array
  readonly #cosines: Float64Array
  readonly #sines: Float64Array

  constructor(count: number) {
    this.#count = count
    const reversed = new Uint32Array(count)
    for (let i = 1; i < count; i++) reversed[i] = (reversed[i >> 1] >> 1) | (i & 1 ? count >> 1 : 0)
    this.#swaps = Uint32Array.from([...reversed.entries()].filter(([i, j]) => i < j).flat())
    const angles = Float64Array.from({ length: count / 2 }, (_, i) => (2 * Math.PI * i) / count)
    this.#cosines = angles.map(cos)
    this.#sines = angles.map((angle) => -sin(angle))
  }

  /**
   * Transforms all sequences of a field. Element i of a sequence is `i * stride` after its first element. Each stage reads a
   * twiddle factor once and applies it to all sequences.
   *
   * @param stride 1 if the sequences are rows, or the width of the field if they are columns.
   */
  run(re: Float64Array, im: Float64Array, stride: number): void {
    const { length } = re
    for (let start = 0; start < length; start += this.#count * stride) this.#reverse(re, im, start, stride)
    let half = 1
    // Pairs of stages touch each number once instead of twice.
    for (; 4 * half <= this.#count; half *= 4) this.#twoStages(re, im, stride, half)
    if (half < this.#count) this.#oneStage(re, im, stride, half)
  }

  /** Reorders `stride` interleaved sequences. */
  #reverse(re: Float64Array, im: Float64Array, start: number, stride: number): void {
    const swaps = this.#swaps
    for (let k = 0; k < swaps.length; k += 2) {
      const first = start + swaps[k] * stride
      const distance = (swaps[k + 1] - swaps[k]) * stride
      for (let a = first; a < first + stride; a++) {
        const x = re[a]
        const y = im[a]
        re[a] = re[a + distance]
        im[a] = im[a + distance]
        re[a + distance] = x
        im[a + distance] = y
      }
    }
  }

  /** Combines parts of `half` elements into parts of `4 * half` elements. */
  #twoStages(re: Float64Array, im: Float64Array, stride: number, half: number): void {
    const cosines = this.#cosines
    const sines = this.#sines
    const step = this.#count / (4 * half)
    const distance = half * stride
    for (let k = 0; k < half; k++) {
      const c1 = cosines[2 * k * step]
      const s1 = sines[2 * k * step]
      const c2 = cosines[k * step]
      const s2 = sines[k * step]
      const c3 = cosines[(k + half) * step]
      const s3 = sines[(k + half) * step]
      for (let first = k * stride; first < re.length; first += 4 * distance) {
        for (let a = first; a < first + stride; a++) {
          const b = a + distance
          const c = b + distance
          const d = c + distance
          const bRe = re[b] * c1 - im[b] * s1
          const bIm = re[b] * s1 + im[b] * c1
          const dRe = re[d] * c1 - im[d] * s1
          const dIm = re[d] * s1 + im[d] * c1
          const evenRe = re[a] + bRe
          const evenIm = im[a] + bIm
          const oddRe = re[a] - bRe
          const oddIm = im[a] - bIm
          const nextEvenRe = re[c] + dRe
          const nextEvenIm = im[c] + dIm
          const nextOddRe = re[c] - dRe
          const nextOddIm = im[c] - dIm
          const xRe = nextEvenRe * c2 - nextEvenIm * s2
          const xIm = nextEvenRe * s2 + nextEvenIm * c2
          const yRe = nextOddRe * c3 - nextOddIm * s3
          const yIm = nextOddRe * s3 + nextOddIm * c3
          re[a] = evenRe + xRe
          im[a] = evenIm + xIm
          re[b] = oddRe + yRe
          im[b] = oddIm + yIm
          re[c] = evenRe - xRe
          im[c] = evenIm - xIm
          re[d] = oddRe - yRe
          im[d] = oddIm - yIm
        }
      }
    }
  }

  /** Combines parts of `half` elements into parts of `2 * half` elements. */
  #oneStage(re: Float64Array, im: Float64Array, stride: number, half: number): void {
    const step = this.#count / (2 * half)
    const distance = half * stride
    for (let k = 0; k < half; k++) {
      const cosine = this.#cosines[k * step]
      const sine = this.#sines[k * step]
      for (let first = k * stride; first < re.length; first += 2 * distance) {
        for (let a = first; a < first + stride; a++) {
          const b = a + distance
          const x = re[b] * cosine - im[b] * sine
          const y = re[b] * sine + im[b] * cosine
          re[b] = re[a] - x
          im[b] = im[a] - y
          re[a] += x
          im[a] += y
        }
      }
    }
  }
}
