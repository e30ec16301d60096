/** Points of an unfinished polygon, drawn over the stage. */
export class PolygonOutline {
  readonly #svg: SVGSVGElement
  readonly #line: SVGPolylineElement
  readonly #points: SVGGElement

  constructor(stage: HTMLElement) {
    this.#svg = create('svg')
    this.#svg.classList.add('polygon-outline')
    this.#svg.ariaHidden = 'true'
    this.#line = create('polyline')
    this.#points = create('g')
    this.#svg.append(this.#line, this.#points)
    stage.append(this.#svg)
  }

  /** @param corners CSS pixels from the stage's upper left corner; an empty array hides the polygon. */
  show(corners: readonly { x: number; y: number }[]): void {
    this.#line.setAttribute('points', corners.map(({ x, y }) => `${x.toFixed(1)},${y.toFixed(1)}`).join(' '))
    this.#points.replaceChildren(
      ...corners.map(({ x, y }, i) => {
        const circle = create('circle')
        circle.setAttribute('cx', x.toFixed(1))
        circle.setAttribute('cy', y.toFixed(1))
        // The first point is larger, because a click on it closes the polygon.
        circle.setAttribute('r', i === 0 ? '6' : '3.5')
        return circle
      }),
    )
  }
}

function create<K extends keyof SVGElementTagNameMap>(name: K): SVGElementTagNameMap[K] {
  return document.createElementNS('http://www.w3.org/2000/svg', name)
}
