import type { LayerStroke } from '../document/document.ts'
import type { ProjectedLine } from './project-lines.ts'

const COLOURS = {
  line: '#ffcf9b',
  hovered: '#fff0dd',
  chosen: '#ff9d2e',
  shadow: 'rgb(40 20 10 / 40%)',
}
/** Minimum distance of drawn points, CSS pixels: the points of a line can be less than a pixel apart. */
const STEP = 3
/** Point radii, CSS pixels. */
const POINT = 4
const CHOSEN_POINT = 6

/** Content of the overlay. */
export interface LinePicture {
  readonly lines: readonly ProjectedLine[]
  readonly chosen: LayerStroke | null
  /** Index of the chosen point, or -1. */
  readonly point: number
  readonly hovered: LayerStroke | null
  readonly path: readonly { x: number; y: number }[]
}

/** Canvas over the stage with thin curves. Independent of the renderer, and not part of pictures of the face. */
export class LineOverlay {
  readonly #canvas = document.createElement('canvas')
  /** Cache of all lines except the chosen one. */
  readonly #others = document.createElement('canvas')
  #drawn: readonly unknown[] = []
  readonly #stage: HTMLElement

  constructor(stage: HTMLElement) {
    this.#stage = stage
    this.#canvas.className = 'lines'
    this.#canvas.hidden = true
    stage.after(this.#canvas)
  }

  get size(): [width: number, height: number] {
    return [this.#stage.clientWidth, this.#stage.clientHeight]
  }

  hide(): void {
    this.#canvas.hidden = true
  }

  draw({ lines, chosen, point, hovered, path }: LinePicture): void {
    this.#canvas.hidden = false
    const context = this.#clear(this.#canvas)
    this.#drawOthers(lines.filter(({ stroke }) => stroke !== chosen))
    context.drawImage(this.#others, 0, 0, ...this.size)
    const over = lines.find(({ stroke }) => stroke === hovered && stroke !== chosen)
    if (over) drawLine(context, over, 'hovered')
    const own = lines.find(({ stroke }) => stroke === chosen)
    if (own) {
      drawLine(context, own, 'chosen')
      drawPoints(context, own, point)
    }
    drawPath(context, path)
  }

  #drawOthers(lines: readonly ProjectedLine[]): void {
    const source = [...this.size, devicePixelRatio, ...lines]
    if (source.length === this.#drawn.length && source.every((each, i) => each === this.#drawn[i])) return
    this.#drawn = source
    const context = this.#clear(this.#others)
    for (const line of lines) drawLine(context, line, 'line')
  }

  /** Clears a canvas and fits it to the stage. */
  #clear(canvas: HTMLCanvasElement): CanvasRenderingContext2D {
    const ratio = Math.min(devicePixelRatio, 2)
    const [width, height] = this.size.map((side) => Math.round(side * ratio))
    canvas.width = width
    canvas.height = height
    // CPU canvas: a software GPU needs seconds for hundreds of thin curves and blocks the page's events.
    const context = canvas.getContext('2d', { willReadFrequently: true })!
    context.scale(ratio, ratio)
    context.lineJoin = 'round'
    context.lineCap = 'round'
    return context
  }
}

/** Returns the visible parts of a line as indices of its drawn points. */
export function visibleParts({ x, y, isSeen }: Pick<ProjectedLine, 'x' | 'y' | 'isSeen'>): number[][] {
  const parts: number[][] = []
  for (let i = 0; i + 1 < x.length; i++) {
    if (!isSeen[i]) continue
    if (i === 0 || !isSeen[i - 1]) parts.push([i])
    const part = parts.at(-1)!
    const last = part.at(-1)!
    const next = i + 1
    const isEnd = next + 1 === x.length || !isSeen[next]
    if (isEnd || Math.hypot(x[next] - x[last], y[next] - y[last]) >= STEP) part.push(next)
  }
  return parts
}

function drawLine(
  context: CanvasRenderingContext2D,
  line: ProjectedLine,
  kind: 'line' | 'hovered' | 'chosen',
): void {
  context.beginPath()
  for (const [first, ...others] of visibleParts(line)) {
    context.moveTo(line.x[first], line.y[first])
    for (const i of others) context.lineTo(line.x[i], line.y[i])
  }
  stroke(context, kind === 'line' ? 1.5 : 2.5, COLOURS[kind])
}

function drawPath(context: CanvasRenderingContext2D, path: LinePicture['path']): void {
  context.beginPath()
  for (const { x, y } of path) context.lineTo(x, y)
  if (path.length > 1) stroke(context, 2, COLOURS.chosen)
}

/** Strokes with a shadow, for contrast on light skin. */
function stroke(context: CanvasRenderingContext2D, width: number, colour: string): void {
  context.lineWidth = width + 2
  context.strokeStyle = COLOURS.shadow
  context.stroke()
  context.lineWidth = width
  context.strokeStyle = colour
  context.stroke()
}

function drawPoints(context: CanvasRenderingContext2D, { x, y, knots }: ProjectedLine, chosen: number): void {
  for (const [index, i] of knots.entries()) {
    context.beginPath()
    context.arc(x[i], y[i], index === chosen ? CHOSEN_POINT : POINT, 0, 2 * Math.PI)
    context.fillStyle = index === chosen ? COLOURS.chosen : '#fff'
    context.fill()
    context.lineWidth = 1.5
    context.strokeStyle = '#212429'
    context.stroke()
  }
}
