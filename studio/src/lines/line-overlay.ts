import type { Handle } from './handles.ts'
import type { LinePicture } from './line-picture.ts'
import type { ProjectedLine } from './project-lines.ts'

const COLOURS = {
  line: '#ffcf9b',
  hovered: '#fff0dd',
  chosen: '#ff9d2e',
  shadow: 'rgb(40 20 10 / 40%)',
  point: '#ffffff',
}
/** Minimum distance between drawn points of a polyline, CSS pixels. Points in between are skipped. */
const STEP = 3
/** Radii of points, CSS pixels: one that stays, and the one that is moved. */
const POINT = 4
const CHOSEN_POINT = 6.5
/** Colour of a point that moves as much as the chosen one, as a fraction of the way from white to that point's colour. */
const NEIGHBOUR = 0.7
/** Half diagonals of the diamonds that mark forks, CSS pixels. */
const FORK = 4
const HANDLE_FORK = 7
const CHOSEN_FORK = 9

/** Canvas over the stage that shows wrinkle lines as thin curves. Saved pictures of the face do not contain it. */
export class LineOverlay {
  readonly #canvas = document.createElement('canvas')
  /** Canvas with all lines except the chosen one. It is drawn again only when these lines change. */
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

  set isFaded(isFaded: boolean) {
    this.#canvas.classList.toggle('faded', isFaded)
  }

  hide(): void {
    this.#canvas.hidden = true
  }

  draw(picture: LinePicture): void {
    this.#canvas.hidden = false
    const context = this.#clear(this.#canvas)
    this.#drawOthers(picture.lines.filter(({ stroke }) => !picture.chosen.includes(stroke)))
    context.drawImage(this.#others, 0, 0, ...this.size)
    drawChosen(context, picture)
  }

  #drawOthers(lines: readonly ProjectedLine[]): void {
    const source = [...this.size, devicePixelRatio, ...lines]
    if (source.length === this.#drawn.length && source.every((each, i) => each === this.#drawn[i])) return
    this.#drawn = source
    const context = this.#clear(this.#others)
    for (const line of lines) drawLine(context, line, 'line')
  }

  /** Gives a canvas the size of the stage. This also clears the canvas. */
  #clear(canvas: HTMLCanvasElement): CanvasRenderingContext2D {
    const ratio = Math.min(devicePixelRatio, 2)
    const [width, height] = this.size.map((side) => Math.round(side * ratio))
    canvas.width = width
    canvas.height = height
    // `willReadFrequently` moves drawing to the CPU. On a software GPU, hundreds of thin curves take seconds and block the page.
    const context = canvas.getContext('2d', { willReadFrequently: true })!
    context.scale(ratio, ratio)
    context.lineJoin = 'round'
    context.lineCap = 'round'
    return context
  }
}

/** Draws the hovered line, the chosen lines with the handles of the main one, all forks, and the path of the pointer. */
export function drawChosen(
  context: CanvasRenderingContext2D,
  { lines, chosen, handles, point, weights, forks, hovered, path }: LinePicture,
): void {
  const over = lines.find(({ stroke }) => stroke === hovered && !chosen.includes(stroke))
  if (over) drawLine(context, over, 'hovered')
  for (const line of lines) if (chosen.includes(line.stroke)) drawLine(context, line, 'chosen')
  const main = lines.find(({ stroke }) => stroke === chosen[0])
  for (const { x, y } of forks) drawDiamond(context, x, y, FORK, COLOURS.line)
  if (main)
    for (const [i, handle] of handles.entries())
      drawHandle(context, main, handle, i === point, weights[i] ?? 0)
  drawPath(context, path)
}

/** Returns the visible parts of a line. Each part is a list with the indices of the points to connect. */
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

/** Draws the current path with a darker border, for contrast on light skin. */
function stroke(context: CanvasRenderingContext2D, width: number, colour: string): void {
  context.lineWidth = width + 2
  context.strokeStyle = COLOURS.shadow
  context.stroke()
  context.lineWidth = width
  context.strokeStyle = colour
  context.stroke()
}

function drawHandle(
  context: CanvasRenderingContext2D,
  { x, y }: ProjectedLine,
  { place, fork }: Handle,
  isChosen: boolean,
  weight: number,
): void {
  const colour = isChosen ? COLOURS.chosen : blend(COLOURS.point, COLOURS.chosen, NEIGHBOUR * weight)
  if (fork) {
    drawDiamond(context, x[place], y[place], isChosen ? CHOSEN_FORK : HANDLE_FORK, colour)
    return
  }
  context.beginPath()
  context.arc(x[place], y[place], POINT + weight * (CHOSEN_POINT - POINT), 0, 2 * Math.PI)
  fill(context, colour)
}

/** Returns the colour at a fraction of the way between two colours, `#rrggbb`. */
function blend(from: string, to: string, t: number): string {
  const channels = [1, 3, 5].map((i) => {
    const [a, b] = [from, to].map((colour) => Number.parseInt(colour.slice(i, i + 2), 16))
    return Math.round(a + t * (b - a))
  })
  return `rgb(${channels.join(' ')})`
}

function drawDiamond(
  context: CanvasRenderingContext2D,
  x: number,
  y: number,
  radius: number,
  colour: string,
): void {
  context.beginPath()
  context.moveTo(x, y - radius)
  context.lineTo(x + radius, y)
  context.lineTo(x, y + radius)
  context.lineTo(x - radius, y)
  context.closePath()
  fill(context, colour)
}

/** Fills the current path, with a dark border. */
function fill(context: CanvasRenderingContext2D, colour: string): void {
  context.fillStyle = colour
  context.fill()
  context.lineWidth = 1.5
  context.strokeStyle = '#212429'
  context.stroke()
}
