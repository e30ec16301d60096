import type { Skin, Surface } from './surface.ts'

/** Texels by which the skin goes on beyond the islands of its texture, in its own plane: slopes there are its own. */
const MARGIN = 3

/** Which texels of a map a skin covers, and where on it they lie. */
export class SkinTexels {
  readonly size: number
  readonly #skin: Pick<Skin, 'uvs' | 'indices'>
  readonly #surface: Surface
  /** For each texel its triangle, or -1. */
  readonly #owner: Int32Array

  /**
   * @param size side of the map in texels.
   * @param drawn tells of each triangle whether it has a say in the texture.
   */
  constructor(
    skin: Pick<Skin, 'uvs' | 'indices'>,
    surface: Surface,
    size: number,
    drawn: (triangle: number) => boolean = () => true,
  ) {
    this.size = size
    this.#skin = skin
    this.#surface = surface
    this.#owner = new Int32Array(size * size).fill(-1)
    const nearest = new Float32Array(size * size).fill(Infinity)
    const place = new Float64Array(6)
    for (let t = 0; t < surface.triangleOf.length; t++) {
      if (!drawn(t)) continue
      this.#place(t, place)
      this.#claim(t, place, nearest)
    }
  }

  /**
   * Visits the texels whose centres triangles cover and a few round the islands.
   *
   * @param wanted tells of each triangle whether to visit its texels.
   * @param visit is given the texel's index, row by row, the triangle and the shares of its corners, which are below 0 beyond an island.
   */
  visit(
    wanted: (triangle: number) => boolean,
    visit: (texel: number, triangle: number, a: number, b: number, c: number) => void,
  ): void {
    const place = new Float64Array(6)
    const known = new Int8Array(this.#surface.triangleOf.length).fill(-1)
    let last = -1
    for (let texel = 0; texel < this.#owner.length; texel++) {
      const t = this.#owner[texel]!
      if (t < 0) continue
      if (known[t]! < 0) known[t] = wanted(t) ? 1 : 0
      if (known[t] === 0) continue
      if (t !== last) this.#place(t, place)
      last = t
      const x = (texel % this.size) - place[0]!
      const y = Math.floor(texel / this.size) - place[1]!
      const ux = place[2]! - place[0]!
      const uy = place[3]! - place[1]!
      const vx = place[4]! - place[0]!
      const vy = place[5]! - place[1]!
      const det = ux * vy - uy * vx
      const b = (x * vy - vx * y) / det
      const c = (ux * y - x * uy) / det
      visit(texel, t, 1 - b - c, b, c)
    }
  }

  /** x and y of a triangle's corners in texels. */
  #place(triangle: number, out: Float64Array): void {
    const { uvs, indices } = this.#skin
    for (let k = 0; k < 3; k++) {
      const vertex = 2 * indices[3 * this.#surface.triangleOf[triangle]! + k]!
      out[2 * k] = uvs[vertex]! * this.size - 0.5
      out[2 * k + 1] = uvs[vertex + 1]! * this.size - 0.5
    }
  }

  /** Gives a triangle the texels that it covers, and those near it that no other is nearer to. */
  #claim(triangle: number, p: Float64Array, nearest: Float32Array): void {
    const { size } = this
    const det = (p[2]! - p[0]!) * (p[5]! - p[1]!) - (p[4]! - p[0]!) * (p[3]! - p[1]!)
    if (Math.abs(det) < 1e-9) return
    const firstRow = Math.max(Math.ceil(Math.min(p[1]!, p[3]!, p[5]!) - MARGIN), 0)
    const lastRow = Math.min(Math.floor(Math.max(p[1]!, p[3]!, p[5]!) + MARGIN), size - 1)
    const firstColumn = Math.max(Math.ceil(Math.min(p[0]!, p[2]!, p[4]!) - MARGIN), 0)
    const lastColumn = Math.min(Math.floor(Math.max(p[0]!, p[2]!, p[4]!) + MARGIN), size - 1)
    const turn = Math.sign(det)
    for (let row = firstRow; row <= lastRow; row++) {
      for (let column = firstColumn; column <= lastColumn; column++) {
        let outside = -Infinity
        for (let k = 0; k < 6; k += 2) {
          const dx = p[(k + 2) % 6]! - p[k]!
          const dy = p[(k + 3) % 6]! - p[k + 1]!
          const off = (turn * (dy * (column - p[k]!) - dx * (row - p[k + 1]!))) / Math.sqrt(dx * dx + dy * dy)
          if (off > outside) outside = off
        }
        if (outside > MARGIN) continue
        const texel = row * size + column
        const distance = outside > 0 ? outside : 0
        if (distance >= nearest[texel]!) continue
        nearest[texel] = distance
        this.#owner[texel] = triangle
      }
    }
  }
}
