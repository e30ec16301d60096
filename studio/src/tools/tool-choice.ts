import { batch, type ReadonlySignal, signal } from '@preact/signals'

/** Modes of the studio: look at the face, edit wrinkle lines, paint regions, and play animations. */
export const MODE_NAMES = ['look', 'lines', 'paint', 'motion'] as const
export type Mode = (typeof MODE_NAMES)[number]

export const TOOL_NAMES = ['select', 'draw', 'bend', 'smooth', 'erase', 'paint', 'polygon', 'sculpt'] as const
export type Tool = (typeof TOOL_NAMES)[number]

/** Mode of each tool. The tool `select` is in the modes `look` and `motion`. */
const MODE_OF: Readonly<Record<Exclude<Tool, 'select'>, Mode>> = {
  draw: 'lines',
  bend: 'lines',
  smooth: 'lines',
  erase: 'lines',
  paint: 'paint',
  polygon: 'paint',
  sculpt: 'paint',
}

/** First tool of each mode. */
const FIRST: Readonly<Record<Mode, Tool>> = {
  look: 'select',
  lines: 'bend',
  paint: 'paint',
  motion: 'select',
}

/** Stores the mode and the tool of the pointer. Each tool except `select` belongs to one mode. */
export class ToolChoice {
  readonly #mode = signal<Mode>('look')
  readonly #tool = signal<Tool>('select')
  /** Whether changes of a line or of painted skin also change the other half of the face. */
  readonly mirror = signal(false)

  get mode(): ReadonlySignal<Mode> {
    return this.#mode
  }

  get tool(): ReadonlySignal<Tool> {
    return this.#tool
  }

  choose(tool: Tool): void {
    const mode = this.#mode.peek()
    const next = tool === 'select' ? (FIRST[mode] === 'select' ? mode : 'look') : MODE_OF[tool]
    batch(() => {
      this.#mode.value = next
      this.#tool.value = tool
    })
  }

  /** Chooses a mode and its first tool. Keeps the tool if it already belongs to the mode. */
  chooseMode(mode: Mode): void {
    if (mode === this.#mode.peek()) return
    batch(() => {
      this.#mode.value = mode
      this.#tool.value = FIRST[mode]
    })
  }
}
