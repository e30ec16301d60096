import type { ReliefMode, WrinkleMode } from '../three/options.ts'
import type { WrinklesBase } from '../three/wrinkles-base.ts'
import { checkState, type WrinkleState } from './wrinkle-state.ts'

type Numbers = Readonly<Record<string, number>>

const NONE: Numbers = {}

/** Applies the properties of a React component to one face. When a property is removed, the face gets its original value back. */
export class DeclaredFace {
  readonly #face: WrinklesBase
  readonly #original: { mode: WrinkleMode; relief: ReliefMode; inputs: Map<string, number> }
  readonly #warn: (error: unknown) => void
  #state: WrinkleState = {}

  /** @param warn receives the error of each property that cannot be applied. Other properties are still applied. */
  constructor(face: WrinklesBase, warn: (error: unknown) => void) {
    this.#face = face
    this.#warn = warn
    this.#original = { mode: face.mode, relief: face.relief, inputs: new Map() }
  }

  /** Applies all properties that differ from the last call. */
  apply(state: WrinkleState): void {
    const [face, original, last] = [this.#face, this.#original, this.#state]
    if (face.isDisposed || state === last) return
    this.#state = state
    this.#attempt(() => checkState(state))
    this.#attempt(() => {
      face.mode = state.mode ?? original.mode
    })
    this.#attempt(() => {
      face.relief = state.relief ?? original.relief
    })
    this.#applyNumbers(last.activations, state.activations, (area, value) => {
      if (face.hasArea(area)) face.setActivation(area, value ?? face.getArea(area)!.activation ?? 0)
    })
    this.#applyNumbers(last.inputs, state.inputs, (name, value) => {
      if (!original.inputs.has(name)) original.inputs.set(name, face.inputs.get(name))
      face.inputs.set(name, value ?? original.inputs.get(name)!)
    })
  }

  /** Calls `set` for each name whose value has changed. The value is undefined if the name was removed. */
  #applyNumbers(
    last: Numbers = NONE,
    next: Numbers = NONE,
    set: (name: string, value: number | undefined) => void,
  ): void {
    for (const name of new Set([...Object.keys(last), ...Object.keys(next)])) {
      if (next[name] !== last[name]) this.#attempt(() => set(name, next[name]))
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
