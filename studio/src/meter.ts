/** Number of frames in the graph and in the medians. */
const FRAMES = 60
/** CPU time at the full height of the graph, milliseconds: one frame at 60 Hz. */
const FULL_SCALE = 1000 / 60
/** Frames between two updates of the text. Faster updates would be illegible. */
const UPDATE_INTERVAL = 6

/** Shows the median CPU time of a frame, frames per second while moving, and a graph of the CPU times. */
export class Meter {
  readonly #text: HTMLElement
  readonly #graph: HTMLCanvasElement
  readonly #cpu: number[] = []
  readonly #intervals: number[] = []
  #frames = 0
  #restTimer = 0

  constructor(text: HTMLElement, graph: HTMLCanvasElement) {
    this.#text = text
    this.#graph = graph
  }

  readonly add = (cpu: number, interval: number | null): void => {
    keep(this.#cpu, cpu)
    if (interval === null) this.#intervals.length = 0
    else keep(this.#intervals, interval)
    if (this.#frames++ % UPDATE_INTERVAL === 0) this.#show(true)
    clearTimeout(this.#restTimer)
    this.#restTimer = window.setTimeout(() => this.#show(false), 300)
  }

  reset(): void {
    this.#cpu.length = 0
    this.#intervals.length = 0
  }

  #show(isMoving: boolean): void {
    if (this.#cpu.length === 0) return
    const rate = this.#intervals.length > 2 ? `${Math.round(1000 / median(this.#intervals))} fps` : ''
    this.#text.textContent = `${median(this.#cpu).toFixed(1)} ms CPU · ${(isMoving && rate) || 'at rest'}`
    this.#draw()
  }

  #draw(): void {
    const { width, height } = this.#graph
    const context = this.#graph.getContext('2d')!
    const barWidth = width / FRAMES
    context.clearRect(0, 0, width, height)
    context.fillStyle = getComputedStyle(this.#graph).color
    for (const [i, cpu] of this.#cpu.entries()) {
      const barHeight = Math.max(1, Math.min(cpu / FULL_SCALE, 1) * height)
      context.fillRect(
        (FRAMES - this.#cpu.length + i) * barWidth,
        height - barHeight,
        barWidth * 0.7,
        barHeight,
      )
    }
  }
}

function keep(values: number[], value: number): void {
  values.push(value)
  if (values.length > FRAMES) values.shift()
}

function median(values: readonly number[]): number {
  const sorted = [...values].sort((a, b) => a - b)
  return sorted[sorted.length >> 1]
}
