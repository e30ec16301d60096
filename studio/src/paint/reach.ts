import type { SkinSurface } from 'furrow/internal'
import type { SkinPoint } from './paint-skin.ts'
import { squaredDistance } from './vectors.ts'

/**
 * Finds the triangles that paths over the skin reach from the centre of a sphere without leaving the sphere. Paths from one lip do not reach
 * the other lip.
 */
export class Reach {
  readonly #surface: SkinSurface
  /** For each triangle: number of the last search that reached it. */
  readonly #visited: Uint32Array
  #search = 0
  #queue = new Uint32Array(64)

  constructor(surface: SkinSurface) {
    this.#surface = surface
    this.#visited = new Uint32Array(surface.skinTriangles.length)
  }

  /**
   * Visits triangles, beginning at the centre and continuing across edges that intersect the sphere.
   *
   * @param radius sphere radius, millimetres.
   */
  visit({ triangle: start, position }: SkinPoint, radius: number, visit: (triangle: number) => void): void {
    const { adjacent, corners, points } = this.#surface
    const square = radius * radius
    const search = ++this.#search
    let count = 0
    this.#queue[count++] = start
    this.#visited[start] = search
    for (let head = 0; head < count; head++) {
      const triangle = this.#queue[head]
      visit(triangle)
      for (let k = 0; k < 3; k++) {
        const next = adjacent[3 * triangle + k]
        if (next < 0 || this.#visited[next] === search) continue
        const [from, to] = [corners[3 * triangle + k], corners[3 * triangle + ((k + 1) % 3)]]
        if (squaredDistance(points, 3 * from, 3 * to, position) >= square) continue
        this.#visited[next] = search
        if (count === this.#queue.length) this.#queue = doubled(this.#queue)
        this.#queue[count++] = next
      }
    }
  }
}

function doubled(queue: Uint32Array): Uint32Array<ArrayBuffer> {
  const larger = new Uint32Array(2 * queue.length)
  larger.set(queue)
  return larger
}
