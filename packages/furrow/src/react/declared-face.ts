import type { ReliefMode, WrinkleMode } from '../three/options.ts'
import type { WrinklesBase } from '../three/wrinkles-base.ts'
import { checkState, type WrinkleState } from './wrinkle-state.ts'

type Numbers = Readonly<Record<string, number>>

const NONE: Numbers = {}

/** A face whose state is declared, and what it was before. */
export class DeclaredFace {
  readonly #face: WrinklesBase
  readonly #before: { mode: WrinkleMode; relief: ReliefMode; inputs: Map<string, number> }
  readonly #warn: (error: unknown) => void
  #state: WrinkleState = {}

  /** @param warn is told of what is not possible; everything else of a state is applied. */
  constructor(face: WrinklesBase, warn: (error: unknown) => void) {
    this.#face = face
    this.#warn = warn
    this.#before = { mode: face.mode, relief: face.relief, inputs: new Map() }
  }

  /** Applies what differs from the last state. */
  apply(state: WrinkleState): void {
    const [face, before, last] = [this.#face, this.#before, this.#state]
    if (face.isDisposed || state === last) return
    this.#state = state
    this.#attempt(() => checkState(state))
    this.#attempt(() => {
      face.mode = state.mode ?? before.mode
    })
    this.#attempt(() => {
      face.relief = state.relief ?? before.relief
    })
    this.#applyNumbers(last.activations, state.activations, (area, value) => {
      if (face.hasArea(area)) face.setActivation(area, value ?? face.getArea(area)!.activation ?? 0)
    })
    this.#applyNumbers(last.inputs, state.inputs, (name, value) => {
      if (!before.inputs.has(name)) before.inputs.set(name, face.inputs.get(name))
      face.inputs.set(name, value ?? before.inputs.get(name)!)
    })
  }

  /** @param set is given undefined for a name that is no longer there. */
  #applyNumbers(
    last: Numbers = NONE,
    now: Numbers = NONE,
    set: (name: string, value: number | undefined) => void,
  ): void {
    for (const name of new Set([...Object.keys(last), ...Object.keys(now)])) {
      if (now[name] !== last[name]) this.#attempt(() => set(name, now[name]))
    }
  }

  #attempt(change: () => void): void {
    try {
      change()
    } catch (error) {
      this.#warn(error)
    }
  }
}
