import { barycentrics2 } from '../../math/barycentrics.ts'
import { uvToTexels } from '../../math/triangle.ts'
import { type BorderEdge, extendPlanes, FILTER_MARGIN } from '../border.ts'
import { coverTexels } from '../cover-texels.ts'
import { type Skin, type SkinSurface, skinVertices } from './surface.ts'

/** How often progress is told. */
const PARTS = 32
/** Owner of a texel far from any island. */
const NONE = -1
/** Barycentric coordinate up to which a texel is on the edge of a triangle. */
const EDGE = 1e-3
/** Twice the area, in square texels, below which a triangle has no plane to be continued in. */
const NO_AREA = 1e-9

/** Which texels of a map a skin covers, and where on it they are. */
export class SkinTexels {
  readonly width: number
  readonly height: number
  readonly surface: SkinSurface
  readonly #skin: Pick<Skin, 'uvs' | 'indices'>
  /** For each texel its triangle; -2 - triangle beyond the islands. */
  readonly #owner: Int32Array
  /** The triangle that was located last, and its corners in texels. */
  #last = NONE
  readonly #corners = new Float64Array(6)

  /**
   * @param width of the map in texels, as is height.
   * @param isDrawn tells whether a triangle is drawn into the texture.
   * @param margin texels by which the skin is continued beyond its islands.
   */
  constructor(
    skin: Pick<Skin, 'uvs' | 'indices'>,
    surface: SkinSurface,
    width: number,
    height: number,
    isDrawn: (triangle: number) => boolean = () => true,
    margin = FILTER_MARGIN,
  ) {
    this.width = width
    this.height = height
    this.surface = surface
    this.#skin = skin
    this.#owner = new Int32Array(width * height).fill(NONE)
    const drawn = surface.skinTriangles.map((_, triangle) => (isDrawn(triangle) ? 1 : 0))
    for (const [triangle, flag] of drawn.entries()) if (flag) this.#cover(triangle)
    extendPlanes(
      () => this.#borderEdges(drawn),
      width,
      height,
      margin,
      (texel) => this.#owner[texel] < 0,
      (texel, triangle) => {
        this.#owner[texel] = -2 - triangle
      },
    )
  }

  /**
   * Visits the texels whose centres triangles cover, and those beyond the islands.
   *
   * @param isWanted tells whether to visit the texels that a triangle covers; those beyond the islands always are.
   * @param visit is given the texel's index, row by row, the triangle and barycentric coordinates, which are below 0 beyond an island.
   */
  visit(
    isWanted: (triangle: number) => boolean,
    visit: (texel: number, triangle: number, a: number, b: number, c: number) => void,
    progress?: (fraction: number) => void,
  ): void {
    const weights = new Float64Array(3)
    /** 1 and 0 as `isWanted` says, -1 where it was not asked yet. */
    const wanted = new Int8Array(this.surface.skinTriangles.length).fill(-1)
    const part = Math.ceil(this.#owner.length / PARTS)
    for (let texel = 0; texel < this.#owner.length; texel++) {
      if (texel % part === part - 1) progress?.(texel / this.#owner.length)
      const triangle = this.#triangleOf(texel)
      if (triangle === NONE) continue
      if (wanted[triangle] < 0) wanted[triangle] = isWanted(triangle) ? 1 : 0
      if (this.#owner[texel] >= 0 && wanted[triangle] === 0) continue
      this.locate(texel, weights)
      visit(texel, triangle, weights[0], weights[1], weights[2])
    }
    progress?.(1)
  }

  /** Visits the texels that triangles cover besides their own one: parts of the skin that use the same texels. */
  visitOverlaps(visit: (texel: number, triangle: number, a: number, b: number, c: number) => void): void {
    for (let triangle = 0; triangle < this.surface.skinTriangles.length; triangle++) {
      const corners = skinVertices(this.#skin, this.surface, triangle)
      coverTexels(this.#skin.uvs, corners, this.width, this.height, (texel, a, b, c) => {
        // Adjacent triangles both cover the texels of their edge.
        if (this.#owner[texel] !== triangle && Math.min(a, b, c) > EDGE) visit(texel, triangle, a, b, c)
      })
    }
  }

  /**
   * Finds where on the skin a texel is.
   *
   * @param weights takes barycentric coordinates, which are below 0 beyond an island.
   * @returns the triangle, -1 where there is none.
   */
  locate(texel: number, weights: Float64Array): number {
    const triangle = this.#triangleOf(texel)
    if (triangle === NONE) return NONE
    if (triangle !== this.#last) this.#toTexels(this.#corners, triangle)
    this.#last = triangle
    barycentrics2(weights, this.#corners, texel % this.width, Math.floor(texel / this.width))
    return triangle
  }

  #triangleOf(texel: number): number {
    const owner = this.#owner[texel]
    return owner < NONE ? -2 - owner : owner
  }

  /** x and y of a triangle's corners in texels. */
  #toTexels(out: Float64Array, triangle: number): void {
    const [a, b, c] = skinVertices(this.#skin, this.surface, triangle)
    uvToTexels(out, this.#skin.uvs, a, b, c, this.width, this.height)
  }

  /** Gives a triangle the texels whose centres it covers and no other has. */
  #cover(triangle: number): void {
    const corners = skinVertices(this.#skin, this.surface, triangle)
    coverTexels(this.#skin.uvs, corners, this.width, this.height, (texel) => {
      if (this.#owner[texel] < 0) this.#owner[texel] = triangle
    })
  }

  *#borderEdges(drawn: Uint32Array): Generator<BorderEdge> {
    const c = new Float64Array(6)
    const vertexCount = this.#skin.uvs.length / 2
    /** From one vertex to another: where several triangles have the same edge, the first one is continued. */
    const seen = new Set<number>()
    for (const [triangle, flag] of drawn.entries()) {
      for (let k = 0; flag && k < 3; k++) {
        const adjacent = this.surface.adjacent[3 * triangle + k]
        if (adjacent >= 0 && drawn[adjacent] && !this.#isCut(triangle, k, adjacent)) continue
        const vertices = skinVertices(this.#skin, this.surface, triangle)
        const edge = vertices[k] * vertexCount + vertices[(k + 1) % 3]
        if (seen.has(edge)) continue
        this.#toTexels(c, triangle)
        if (Math.abs((c[2] - c[0]) * (c[5] - c[1]) - (c[4] - c[0]) * (c[3] - c[1])) < NO_AREA) continue
        seen.add(edge)
        const [start, end] = [2 * k, (2 * k + 2) % 6]
        const [x, y] = [c[start], c[start + 1]]
        yield { triangle, x, y, dx: c[end] - x, dy: c[end + 1] - y }
      }
    }
  }

  /** Whether two triangles that share an edge in space do not share it in the texture. */
  #isCut(triangle: number, edge: number, adjacent: number): boolean {
    const { uvs } = this.#skin
    const own = skinVertices(this.#skin, this.surface, triangle)
    const others = skinVertices(this.#skin, this.surface, adjacent)
    return [own[edge], own[(edge + 1) % 3]].some(
      (vertex) =>
        !others.some((i) => uvs[2 * i] === uvs[2 * vertex] && uvs[2 * i + 1] === uvs[2 * vertex + 1]),
    )
  }
}
