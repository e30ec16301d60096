import { Vector3 } from 'three'
import type { StudioDocument } from '../document/document.ts'
import type { SkinHit } from '../paint/picker.ts'
import type { Viewer } from '../viewer/viewer.ts'

const CORNERS = 64

interface RingPlace {
  /** Point of the skin under the brush, or null. */
  hit: SkinHit | null
  viewer: Viewer | null
  document: StudioDocument | null
  radiusAt(hit: SkinHit): number
}

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
   * Draws the outline at a point of the skin. Hides it if there is no point, viewer or document.
   *
   * @param radiusAt returns the radius at the point, millimetres.
   */
  update({ hit, viewer, document, radiusAt }: RingPlace): void {
    if (!hit || !viewer || !document) {
      this.#outline.removeAttribute('points')
      return
    }
    const { camera } = viewer.stage
    const { clientWidth, clientHeight } = this.#svg
    const corners = circle(hit.point, hit.normal, radiusAt(hit) / document.scale).map((corner) => {
      const { x, y } = corner.project(camera)
      return `${(((1 + x) / 2) * clientWidth).toFixed(1)},${(((1 - y) / 2) * clientHeight).toFixed(1)}`
    })
    this.#outline.setAttribute('points', corners.join(' '))
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
