import type { SkinSurface } from 'furrow/internal'
import type { SkinPoint } from './paint-skin.ts'
import { squaredDistance } from './vectors.ts'

/** Finds the skin inside a sphere that is connected with its centre there. The other lip is near but not connected. */
export class Reach {
  readonly #surface: SkinSurface
  /** Last search that reached each triangle. */
  readonly #visited: Uint32Array
  #search = 0
  #queue = new Uint32Array(64)

  constructor(surface: SkinSurface) {
    this.#surface = surface
    this.#visited = new Uint32Array(surface.skinTriangles.length)
  }

  /**
   * Grows over the surface across edges that intersect the sphere.
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
