import type { Bounds } from '../../core/bounds.ts'
import { barycentrics2, interpolate } from '../../math/barycentrics.ts'
import { uvToTexels } from '../../math/triangle.ts'
import { type BorderEdge, extendPlanes, FILTER_MARGIN } from '../border.ts'
import { coverTexels } from '../cover-texels.ts'
import { cornersOf, type Skin, type SkinSurface, skinVertices } from './surface.ts'

/** Maximum number of progress reports. */
const PROGRESS_STEPS = 32
/** Width and height in texels of the tiles that `visitNear` tests. */
const TILE = 8
/** Value in `owners` for texels without a triangle. */
const NONE = -1
/** A texel is on the edge of a triangle if its smallest barycentric coordinate is at most this. */
const EDGE = 1e-3
/** Twice the minimum UV area, in square texels, of a triangle that is extended into the margin around its island. */
const NO_AREA = 1e-9

/**
 * Receives a texel's index, and the position and normal of the skin at the texel. The normal is not normalised. The next call reuses the
 * arrays. Outside the UV islands, the position is in the plane of the nearest border triangle, and the normal is interpolated on its edge.
 */
export type TexelVisitor = (texel: number, position: Float64Array, normal: Float64Array) => void

/** Finds the triangle and the position on the skin at each texel of a map, including a margin around the UV islands. */
export class SkinTexels {
  readonly width: number
  readonly height: number
  readonly surface: SkinSurface
  readonly #skin: Pick<Skin, 'uvs' | 'indices'>
  /** Triangle at each texel: -1 if there is no skin, `-2 - triangle` if the texel is in the margin around the islands. */
  readonly owners: Int32Array
  /** Bounding box of the skin in each tile, computed on first access. */
  #boxes: Float64Array | undefined
  readonly #weights = new Float64Array(3)
  readonly #position = new Float64Array(3)
  readonly #normal = new Float64Array(3)
  /** Cache of `locate`: the last triangle, and its corners in texels. */
  #last = NONE
  readonly #corners = new Float64Array(6)

  /**
   * @param width map width in texels.
   * @param height map height in texels.
   * @param isDrawn selects the triangles to draw into the texture. To reuse the `owners` of an earlier instance, pass that array.
   * @param margin width in texels of the margin around the islands.
   */
  constructor(
    skin: Pick<Skin, 'uvs' | 'indices'>,
    surface: SkinSurface,
    width: number,
    height: number,
    isDrawn: ((triangle: number) => boolean) | Int32Array = () => true,
    margin = FILTER_MARGIN,
  ) {
    this.width = width
    this.height = height
    this.surface = surface
    this.#skin = skin
    if (isDrawn instanceof Int32Array) {
      this.owners = isDrawn
      return
    }
    this.owners = new Int32Array(width * height).fill(NONE)
    const drawn = surface.skinTriangles.map((_, triangle) => (isDrawn(triangle) ? 1 : 0))
    for (const [triangle, flag] of drawn.entries()) if (flag) this.#cover(triangle)
    const border = this.#borderEdges(drawn)
    extendPlanes(
      () => this.#inTexels(border),
      width,
      height,
      margin,
      (texel) => this.owners[texel] < 0,
      (texel, triangle) => {
        this.owners[texel] = -2 - triangle
      },
    )
  }

  /**
   * Visits every texel that has a triangle, in the islands and in the margin around them.
   *
   * @param visit called with the texel's row-major index, the triangle and the texel's barycentric coordinates. Some of the coordinates are
   *   negative in the margin.
   */
  visit(visit: (texel: number, triangle: number, a: number, b: number, c: number) => void): void {
    const weights = new Float64Array(3)
    for (let texel = 0; texel < this.owners.length; texel++) {
      const triangle = this.locate(texel, weights)
      if (triangle !== NONE) visit(texel, triangle, weights[0], weights[1], weights[2])
    }
  }

  /**
   * Visits all texels of the tiles that `isNear` accepts.
   *
   * @param isNear receives the lowest and highest x, y and z of the skin in a tile.
   */
  visitNear(
    isNear: (low: Float64Array, high: Float64Array) => boolean,
    visit: TexelVisitor,
    progress?: (fraction: number) => void,
  ): void {
    let reported = 0
    for (const done of this.visitNearInSteps(isNear, visit)) {
      if (done - reported < 1 / PROGRESS_STEPS) continue
      reported = done
      progress?.(done)
    }
    progress?.(1)
  }

  /** Works like `visitNear`, but yields the finished fraction after each visited tile of 64 texels, so that the caller can pause. */
  *visitNearInSteps(
    isNear: (low: Float64Array, high: Float64Array) => boolean,
    visit: TexelVisitor,
  ): Generator<number, void> {
    const tiles = this.#tileCount()
    this.#boxes ??= this.#tileBoxes()
    const [low, high] = [new Float64Array(3), new Float64Array(3)]
    for (let tile = 0; tile < tiles; tile++) {
      for (let k = 0; k < 3; k++) {
        low[k] = this.#boxes[6 * tile + k]
        high[k] = this.#boxes[6 * tile + 3 + k]
      }
      if (!isNear(low, high)) continue
      this.#visitTile(tile, visit)
      yield (tile + 1) / tiles
    }
  }

  /** Visits texels that several triangles cover in UV space, once for each triangle that is not the texel's owner. */
  visitOverlaps(visit: (texel: number, triangle: number, a: number, b: number, c: number) => void): void {
    for (let triangle = 0; triangle < this.surface.skinTriangles.length; triangle++) {
      const corners = skinVertices(this.#skin, this.surface, triangle)
      coverTexels(this.#skin.uvs, corners, this.width, this.height, (texel, a, b, c) => {
        // Adjacent triangles both cover the texels on their shared edge. These texels are no overlap.
        if (this.owners[texel] !== triangle && Math.min(a, b, c) > EDGE) visit(texel, triangle, a, b, c)
      })
    }
  }

  #tileCount(): number {
    return Math.ceil(this.width / TILE) * Math.ceil(this.height / TILE)
  }

  /** Returns the lowest and highest x, y and z of the skin in each tile. In tiles without skin, the lowest is greater than the highest. */
  #tileBoxes(): Float64Array {
    const boxes = new Float64Array(6 * this.#tileCount())
    for (let first = 0; first < boxes.length; first += 6) {
      boxes.fill(Infinity, first, first + 3)
      boxes.fill(-Infinity, first + 3, first + 6)
      const { x0, y0, x1, y1 } = this.#boundsOf(first / 6)
      for (let row = y0; row < y1; row++) {
        // Positions are linear along a run of texels with the same owner, so only the first and the last texel of the run count.
        const end = row * this.width + x1
        for (let texel = row * this.width + x0; texel < end; texel++) {
          const owner = this.owners[texel]
          if (owner === NONE) continue
          this.#widen(boxes, first, texel)
          if (texel + 1 === end || this.owners[texel + 1] !== owner) continue
          while (texel + 1 < end && this.owners[texel + 1] === owner) texel++
          this.#widen(boxes, first, texel)
        }
      }
    }
    return boxes
  }

  /** Expands the box at index `first` to contain the position of a texel. */
  #widen(boxes: Float64Array, first: number, texel: number): void {
    const weights = this.#weights
    const [a, b, c] = cornersOf(this.surface, this.locate(texel, weights))
    const position = this.#position
    interpolate(position, this.surface.points, 3, a, b, c, weights[0], weights[1], weights[2])
    for (let k = first; k < first + 3; k++) {
      boxes[k] = Math.min(boxes[k], position[k - first])
      boxes[k + 3] = Math.max(boxes[k + 3], position[k - first])
    }
  }

  #boundsOf(tile: number): Bounds {
    const columns = Math.ceil(this.width / TILE)
    const x0 = TILE * (tile % columns)
    const y0 = TILE * Math.floor(tile / columns)
    return { x0, y0, x1: Math.min(x0 + TILE, this.width), y1: Math.min(y0 + TILE, this.height) }
  }

  #visitTile(tile: number, visit: TexelVisitor): void {
    const { surface, width } = this
    const { x0, y0, x1, y1 } = this.#boundsOf(tile)
    const weights = this.#weights
    for (let row = y0; row < y1; row++) {
      for (let texel = row * width + x0; texel < row * width + x1; texel++) {
        const triangle = this.locate(texel, weights)
        if (triangle === NONE) continue
        const [a, b, c] = cornersOf(surface, triangle)
        interpolate(this.#position, surface.points, 3, a, b, c, weights[0], weights[1], weights[2])
        // In the margin, positions are in the plane of the border triangle, but normals are interpolated on its edge.
        for (let k = 0; k < 3; k++) weights[k] = Math.max(weights[k], 0)
        interpolate(this.#normal, surface.normals, 3, a, b, c, weights[0], weights[1], weights[2])
        visit(texel, this.#position, this.#normal)
      }
    }
  }

  /**
   * Locates a texel on the skin.
   *
   * @param weights receives the barycentric coordinates; some are negative in the margin around the islands.
   * @returns the texel's triangle, -1 if there is none.
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
    const owner = this.owners[texel]
    return owner < NONE ? -2 - owner : owner
  }

  /** Computes x and y of a triangle's corners in texels. */
  #toTexels(out: Float64Array, triangle: number): void {
    const [a, b, c] = skinVertices(this.#skin, this.surface, triangle)
    uvToTexels(out, this.#skin.uvs, a, b, c, this.width, this.height)
  }

  /** Makes a triangle the owner of the texels whose centres it covers, unless they already have an owner. */
  #cover(triangle: number): void {
    const corners = skinVertices(this.#skin, this.surface, triangle)
    coverTexels(this.#skin.uvs, corners, this.width, this.height, (texel) => {
      if (this.owners[texel] < 0) this.owners[texel] = triangle
    })
  }

  /** Returns the edges at the borders of islands, as `3 * t + k` for the edge from corner k of triangle t. */
  #borderEdges(drawn: Uint32Array): number[] {
    const { adjacent } = this.surface
    const c = new Float64Array(6)
    const vertexCount = this.#skin.uvs.length / 2
    const edges: number[] = []
    /** Vertex pairs of the edges already returned. If several triangles share a border edge, only the first triangle's edge is returned. */
    const seen = new Set<number>()
    for (let edge = 0; edge < 3 * drawn.length; edge++) {
      const triangle = Math.floor(edge / 3)
      const across = adjacent[edge]
      if (!drawn[triangle] || (across >= 0 && drawn[across] && !this.#isCut(edge, across))) continue
      const vertices = this.#vertexAt(edge) * vertexCount + this.#vertexAt(nextEdge(edge))
      if (seen.has(vertices)) continue
      this.#toTexels(c, triangle)
      if (Math.abs((c[2] - c[0]) * (c[5] - c[1]) - (c[4] - c[0]) * (c[3] - c[1])) < NO_AREA) continue
      seen.add(vertices)
      edges.push(edge)
    }
    return edges
  }

  *#inTexels(edges: readonly number[]): Generator<BorderEdge> {
    const c = new Float64Array(6)
    for (const edge of edges) {
      const triangle = Math.floor(edge / 3)
      this.#toTexels(c, triangle)
      const [start, end] = [2 * (edge % 3), 2 * (nextEdge(edge) % 3)]
      const [x, y] = [c[start], c[start + 1]]
      yield { triangle, x, y, dx: c[end] - x, dy: c[end + 1] - y }
    }
  }

  /** Returns whether an edge is a UV seam. */
  #isCut(edge: number, across: number): boolean {
    return (
      !this.#hasCorner(across, this.#vertexAt(edge)) ||
      !this.#hasCorner(across, this.#vertexAt(nextEdge(edge)))
    )
  }

  /** Returns whether a triangle has a corner at a vertex's UV coordinates. */
  #hasCorner(triangle: number, vertex: number): boolean {
    const { uvs } = this.#skin
    for (let corner = 3 * triangle; corner < 3 * triangle + 3; corner++) {
      const other = this.#vertexAt(corner)
      if (uvs[2 * other] === uvs[2 * vertex] && uvs[2 * other + 1] === uvs[2 * vertex + 1]) return true
    }
    return false
  }

  /** Returns the skin's vertex at corner k of triangle t, given `3 * t + k`. */
  #vertexAt(corner: number): number {
    return this.#skin.indices[3 * this.surface.skinTriangles[Math.floor(corner / 3)] + (corner % 3)]
  }
}

function nextEdge(edge: number): number {
  return edge % 3 === 2 ? edge - 2 : edge + 1
}
