import { type Camera, Vector3 } from 'three'

const CORNERS = 64

/** Brush outline on the face, drawn over the stage. */
export class BrushRing {
  readonly #svg: SVGSVGElement
  readonly #outline: SVGPolygonElement

  /** @param stage element over which the outline is drawn. */
  constructor(stage: HTMLElement) {
    this.#svg = document.createElementNS('http://www.w3.org/2000/svg', 'svg')
    this.#svg.classList.add('brush-ring')
    this.#svg.ariaHidden = 'true'
    this.#outline = document.createElementNS('http://www.w3.org/2000/svg', 'polygon')
    this.#svg.append(this.#outline)
    stage.append(this.#svg)
  }

  /**
   * @param point position on the skin, world space.
   * @param normal unit normal of the skin, world space.
   * @param radius radius in world units.
   */
  show(point: Vector3, normal: Vector3, radius: number, camera: Camera): void {
    const { clientWidth, clientHeight } = this.#svg
    const corners = circle(point, normal, radius).map((corner) => {
      const { x, y } = corner.project(camera)
      return `${(((1 + x) / 2) * clientWidth).toFixed(1)},${(((1 - y) / 2) * clientHeight).toFixed(1)}`
    })
    this.#outline.setAttribute('points', corners.join(' '))
  }

  hide(): void {
    this.#outline.removeAttribute('points')
  }
}

/** Returns the corners of a regular polygon around a point. The plane of the polygon is perpendicular to a unit normal. */
export function circle(centre: Vector3, normal: Vector3, radius: number): Vector3[] {
  const axis = new Vector3(0, 0, 0).setComponent(Math.abs(normal.x) < 0.5 ? 0 : 1, 1)
  const right = new Vector3().crossVectors(normal, axis).normalize()
  const up = new Vector3().crossVectors(normal, right)
  return Array.from({ length: CORNERS }, (_, i) => {
    const angle = (2 * Math.PI * i) / CORNERS
    return centre
      .clone()
      .addScaledVector(right, radius * Math.cos(angle))
      .addScaledVector(up, radius * Math.sin(angle))
  })
}
