import { coverTexels } from '../cover-texels.ts'
import type { Skin, Surface } from './surface.ts'

/** Texels by which the skin goes on beyond the islands of its texture, in its own plane: enough for filtering without mipmaps. */
const MARGIN = 3
/** The same for maps with mipmaps: at the third level filtering reaches 12 texels out, and slopes are taken over two more. */
export const MIP_MARGIN = 14

/** Which texels of a map a skin covers, and where on it they lie. */
export class SkinTexels {
  readonly size: number
  readonly #skin: Pick<Skin, 'uvs' | 'indices'>
  readonly #surface: Surface
  /** For each texel its triangle; -2 less the triangle beyond the islands, -1 far from them. */
  readonly #owner: Int32Array

  /**
   * @param size side of the map in texels.
   * @param drawn tells of each triangle whether it has a say in the texture.
   * @param margin texels by which the skin goes on beyond its islands.
   */
  constructor(
    skin: Pick<Skin, 'uvs' | 'indices'>,
    surface: Surface,
    size: number,
    drawn: (triangle: number) => boolean = () => true,
    margin = MARGIN,
  ) {
    this.size = size
    this.#skin = skin
    this.#surface = surface
    this.#owner = new Int32Array(size * size).fill(-1)
    const isDrawn = surface.triangleOf.map((_, t) => (drawn(t) ? 1 : 0))
    for (const [t, isOne] of isDrawn.entries()) if (isOne) this.#cover(t)
    const nearest = new Float32Array(size * size).fill(Infinity)
    for (const [t, isOne] of isDrawn.entries()) {
      for (let k = 0; isOne && k < 3; k++) {
        const beyond = surface.beyond[3 * t + k]!
        if (beyond < 0 || isDrawn[beyond] === 0 || this.#isCut(t, k, beyond))
          this.#goOn(t, k, margin, nearest)
      }
    }
  }

  /**
   * Visits the texels whose centres triangles cover and a few round the islands.
   *
   * @param wanted tells of each triangle whether to visit the texels that it covers; those beyond the islands always are.
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
      const owner = this.#owner[texel]!
      if (owner === -1) continue
      const t = owner < 0 ? -2 - owner : owner
      if (known[t]! < 0) known[t] = wanted(t) ? 1 : 0
      if (owner >= 0 && known[t] === 0) continue
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
    const { uvs } = this.#skin
    for (let k = 0; k < 3; k++) {
      const vertex = 2 * this.#vertex(triangle, k)
      out[2 * k] = uvs[vertex]! * this.size - 0.5
      out[2 * k + 1] = uvs[vertex + 1]! * this.size - 0.5
    }
  }

  /** Gives a triangle the texels whose centres it covers and no other had. */
  #cover(triangle: number): void {
    const corners = [0, 1, 2].map((k) => this.#vertex(triangle, k)) as [number, number, number]
    coverTexels(this.#skin.uvs, corners, this.size, this.size, (texel) => {
      if (this.#owner[texel]! < 0) this.#owner[texel] = triangle
    })
  }

  /** Whether two triangles that share an edge in space do not in the texture. */
  #isCut(triangle: number, edge: number, beyond: number): boolean {
    const { uvs } = this.#skin
    const others = [0, 1, 2].map((k) => 2 * this.#vertex(beyond, k))
    return [edge, (edge + 1) % 3].some((k) => {
      const own = 2 * this.#vertex(triangle, k)
      return !others.some((other) => uvs[other] === uvs[own] && uvs[other + 1] === uvs[own + 1])
    })
  }

  /** Gives a triangle the free texels beyond an edge that no other edge of an island is nearer to. */
  #goOn(triangle: number, edge: number, margin: number, nearest: Float32Array): void {
    const { size } = this
    const place = new Float64Array(6)
    this.#place(triangle, place)
    const [x1, y1, x2, y2, x3, y3] = [...place] as [number, number, number, number, number, number]
    if (Math.abs((x2 - x1) * (y3 - y1) - (x3 - x1) * (y2 - y1)) < 1e-9) return
    const [x, y] = [place[2 * edge]!, place[2 * edge + 1]!]
    const [dx, dy] = [place[(2 * edge + 2) % 6]! - x, place[(2 * edge + 3) % 6]! - y]
    const square = dx * dx + dy * dy || 1
    const lastRow = Math.min(Math.floor(Math.max(y, y + dy) + margin), size - 1)
    const lastColumn = Math.min(Math.floor(Math.max(x, x + dx) + margin), size - 1)
    for (let row = Math.max(Math.ceil(Math.min(y, y + dy) - margin), 0); row <= lastRow; row++) {
      for (
        let column = Math.max(Math.ceil(Math.min(x, x + dx) - margin), 0);
        column <= lastColumn;
        column++
      ) {
        const texel = row * size + column
        if (this.#owner[texel]! >= 0) continue
        const share = Math.min(1, Math.max(0, ((column - x) * dx + (row - y) * dy) / square))
        const distance = Math.hypot(column - x - share * dx, row - y - share * dy)
        if (distance > margin || distance >= nearest[texel]!) continue
        nearest[texel] = distance
        this.#owner[texel] = -2 - triangle
      }
    }
  }

  #vertex(triangle: number, corner: number): number {
    return this.#skin.indices[3 * this.#surface.triangleOf[triangle]! + corner]!
  }
}
