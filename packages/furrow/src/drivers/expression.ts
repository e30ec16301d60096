import { driversOf, type WrinkleDriver } from '../core/driver-types.ts'
import { FurrowError } from '../core/error.ts'

/** What a face does: how far each blendshape goes and how much of each area shows. */
export interface Expression {
  name: string
  /** Blendshape weights by ARKit's names, 0..1; what is not named is 0. */
  targets: Readonly<Record<string, number>>
  /** Activations by area, 0..1; what is not named is 0. */
  activations: Readonly<Record<string, number>>
}

/** The presets among a file's drivers. */
export function expressionsOf(drivers: readonly WrinkleDriver[]): Expression[] {
  return driversOf('expression', drivers).map(({ name, targets, activations }) => ({
    name,
    targets: Object.fromEntries(targets.map(({ name, weight }) => [name, weight])),
    activations: Object.fromEntries(activations.map(({ area, activation }) => [area, activation])),
  }))
}

/**
 * Linear interpolation from one expression to the next over a given time, on the CPU (the paper's own way of
 * driving the wrinkles). Values stand in one array whose order `names` gives; nothing is allocated by `update`.
 */
export class ExpressionMix {
  /** The union of all names that any of the expressions uses, targets and activations apart. */
  readonly targetNames: readonly string[]
  readonly areaNames: readonly string[]
  /** Weights now, in the order of `targetNames`. */
  readonly targets: Float32Array
  /** Activations now, in the order of `areaNames`. */
  readonly activations: Float32Array

  readonly #expressions: ReadonlyMap<string, Ends>
  #from: Ends
  #to: Ends
  #duration = 0
  #elapsed = 0

  /**
   * @param expressions at least one; the first is where the mix starts.
   * @throws FurrowError when there is none.
   */
  constructor(expressions: readonly Expression[]) {
    if (expressions.length === 0) {
      throw new FurrowError({
        who: 'ExpressionMix',
        what: 'no expressions',
        value: 0,
        limit: 'at least 1',
        remedy: 'give a list such as EXPRESSIONS',
      })
    }
    this.targetNames = union(expressions.map((expression) => expression.targets))
    this.areaNames = union(expressions.map((expression) => expression.activations))
    this.#expressions = new Map(
      expressions.map(({ name, targets, activations }) => [
        name,
        {
          targets: Float32Array.from(this.targetNames, (target) => targets[target] ?? 0),
          activations: Float32Array.from(this.areaNames, (area) => activations[area] ?? 0),
        },
      ]),
    )
    this.#to = this.#expressions.get(expressions[0].name)!
    this.targets = this.#to.targets.slice()
    this.activations = this.#to.activations.slice()
    this.#from = { targets: this.targets.slice(), activations: this.activations.slice() }
  }

  /** Whether it has arrived. */
  get still(): boolean {
    return this.#elapsed >= this.#duration
  }

  /**
   * Heads for an expression from wherever the mix is now.
   *
   * @param seconds time to get there; 0 arrives at the next `update`.
   * @throws FurrowError when no expression has that name, or the time is negative or not finite.
   */
  play(name: string, seconds = 0): void {
    const to = this.#expressions.get(name)
    if (to === undefined) {
      throw new FurrowError({
        who: 'ExpressionMix',
        what: 'unknown expression',
        value: name,
        limit: [...this.#expressions.keys()].join(', '),
        remedy: 'use one of these, or pass your own list of expressions',
      })
    }
    if (!(seconds >= 0 && seconds < Infinity)) {
      throw new FurrowError({
        who: 'ExpressionMix',
        what: 'time out of range',
        value: seconds,
        limit: '0 seconds or more',
        remedy: 'give the time the change shall take, e.g. 0.3',
      })
    }
    this.#from.targets.set(this.targets)
    this.#from.activations.set(this.activations)
    this.#to = to
    this.#duration = seconds
    this.#elapsed = 0
    if (seconds === 0) this.update(0)
  }

  /** @param delta seconds since the last call. */
  update(delta: number): void {
    this.#elapsed = Math.min(this.#elapsed + delta, this.#duration)
    this.#interpolate('targets')
    this.#interpolate('activations')
  }

  /** Takes no number: one that is handed to a function which is not inlined is allocated. */
  #interpolate(values: keyof Ends): void {
    const share = this.#duration === 0 ? 1 : this.#elapsed / this.#duration
    const from = this.#from[values]
    const to = this.#to[values]
    const out = this[values]
    for (let i = 0; i < out.length; i++) out[i] = from[i] * (1 - share) + to[i] * share
  }
}

interface Ends {
  targets: Float32Array
  activations: Float32Array
}

function union(records: readonly Readonly<Record<string, number>>[]): string[] {
  return [...new Set(records.flatMap((record) => Object.keys(record)))]
}
