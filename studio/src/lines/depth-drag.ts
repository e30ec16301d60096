import type { StagePointer } from '../tools/stage-tool.ts'
import type { ProjectedLine } from './project-lines.ts'

/** Change of the depth per CSS pixel, millimetres. */
const DEPTH_PER_PIXEL = 0.01
/** Distance that the pointer must move before the depth changes, CSS pixels. */
const THRESHOLD = 4
/** Largest depth and largest height of a bulge, millimetres. */
const MAX_DEPTH = 3

type Position = Pick<StagePointer, 'x' | 'y'>
type Direction = readonly [x: number, y: number]

/** Gesture across a line that changes its depth: downwards (or to the right, for an upright line) deepens it, the other way flattens it. */
export class DepthDrag {
  readonly #start: Position
  readonly #depth: number
  readonly #across: Direction
  #isBegun = false

  /**
   * @param depth depth of the line at the start, millimetres. A negative depth is the height of a bulge.
   * @param across unit direction of deepening on the screen.
   */
  constructor(start: Position, depth: number, across: Direction) {
    this.#start = start
    this.#depth = depth
    this.#across = across
  }

  /** Returns the depth at a position of the pointer, or undefined before the pointer has moved far enough. */
  to({ x, y }: Position): number | undefined {
    const distance = (x - this.#start.x) * this.#across[0] + (y - this.#start.y) * this.#across[1]
    this.#isBegun ||= Math.abs(distance) >= THRESHOLD
    if (!this.#isBegun) return undefined
    const size = Math.max(0, Math.abs(this.#depth) + distance * DEPTH_PER_PIXEL)
    const rounded = Math.round(100 * Math.min(size, MAX_DEPTH)) / 100
    return this.#depth < 0 ? -rounded : rounded
  }
}

/** Returns the unit direction across a line on the screen: downwards, or to the right where the line is upright. */
export function acrossLine({ x, y, along }: Pick<ProjectedLine, 'x' | 'y' | 'along'>, at: number): Direction {
  const next = along.findIndex((each) => each >= at)
  const i = Math.min(Math.max(next, 1), along.length - 1)
  const [dx, dy] = [x[i] - x[i - 1], y[i] - y[i - 1]]
  const length = Math.hypot(dx, dy) || 1
  const [across, down] = [-dy / length, dx / length]
  const isForward = Math.abs(down) > 1e-6 ? down > 0 : across > 0
  return isForward ? [across, down] : [-across, -down]
}
