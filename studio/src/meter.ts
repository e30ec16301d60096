/** Frames that the graph shows, and that the median is taken of. */
const FRAMES = 60
/** Milliseconds at the top of the graph: one frame at 60 Hz. */
const TOP = 1000 / 60
/** Frames between two updates of the numbers, so that they can be read. */
const PACE = 6

/** Shows what frames cost: the median time on the CPU, frames per second while moving, and a graph of both. */
export class Meter {
  readonly #text: HTMLElement
  readonly #graph: HTMLCanvasElement
  readonly #cpu: number[] = []
  readonly #intervals: number[] = []
  #frames = 0
  #rest = 0

  constructor(text: HTMLElement, graph: HTMLCanvasElement) {
    this.#text = text
    this.#graph = graph
  }

  readonly add = (cpu: number, interval: number | null): void => {
    keep(this.#cpu, cpu)
    if (interval === null) this.#intervals.length = 0
    else keep(this.#intervals, interval)
    if (this.#frames++ % PACE === 0) this.#show(true)
    clearTimeout(this.#rest)
    this.#rest = window.setTimeout(() => this.#show(false), 300)
  }

  reset(): void {
    this.#cpu.length = 0
    this.#intervals.length = 0
  }

  #show(moving: boolean): void {
    if (this.#cpu.length === 0) return
    const rate = this.#intervals.length > 2 ? `${Math.round(1000 / median(this.#intervals))} fps` : ''
    this.#text.textContent = `${median(this.#cpu).toFixed(1)} ms CPU · ${(moving && rate) || 'at rest'}`
    this.#draw()
  }

  #draw(): void {
    const { width, height } = this.#graph
    const context = this.#graph.getContext('2d')!
    const bar = width / FRAMES
    context.clearRect(0, 0, width, height)
    context.fillStyle = getComputedStyle(this.#graph).color
    for (const [i, cpu] of this.#cpu.entries()) {
      const tall = Math.max(1, Math.min(cpu / TOP, 1) * height)
      context.fillRect((FRAMES - this.#cpu.length + i) * bar, height - tall, bar * 0.7, tall)
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
