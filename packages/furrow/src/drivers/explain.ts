import { inputName } from './activation.ts'
import type { Link } from './link.ts'
import { planDrivers } from './plan.ts'
import { DriverProgram, type DriverState } from './program.ts'
import type { WrinkleDriver } from './registry.ts'
import { targetSource, valueSource } from './sources.ts'

/** Contribution of one link to its driver. */
export interface LinkPart {
  link: Link
  /** Value before the driver's rule and curve. */
  value: number
}

/** Contribution of one driver to an area. */
export interface DriverPart {
  driver: WrinkleDriver
  /** 0..1. The sum over an area's drivers and its resting activation is clamped to 1. */
  activation: number
  /** Links in the order of the driver. */
  links: LinkPart[]
}

/** Explanation of the activation of an area. */
export interface Explanation {
  /** Name of the area. */
  area: string
  /** 0..1. */
  activation: number
  /** Resting activation, 0..1. */
  resting: number
  /** Drivers of the area, in evaluation order. */
  parts: DriverPart[]
}

/** State of a face for `explain`. */
export interface Situation {
  /** Names of the mesh's blendshapes. */
  targetNames: readonly string[]
  /** Weights of the blendshapes, in the same order. */
  weights: ArrayLike<number>
  /** Custom inputs by name, such as `age` in years. */
  inputs?: Readonly<Record<string, number>>
}

/**
 * Evaluates drivers for one state of a face and returns the contribution of each link. Skips drivers of joints and tension (`needsMesh`),
 * and delays: activations are the values after all delays.
 *
 * @param drivers all drivers of the face.
 * @param areas areas with resting activations, 0..1; default 0.
 * @param situation weights of blendshapes and custom inputs.
 * @returns one explanation per area, in the same order.
 */
export function explain(
  drivers: readonly WrinkleDriver[],
  areas: readonly { name: string; activation?: number }[],
  situation: Situation,
): Explanation[] {
  const { targetNames, weights, inputs = {} } = situation
  const plan = planDrivers(drivers)
  const values = valueSource(plan.inputs.value)
  const program = new DriverProgram(plan, {
    target: targetSource(plan.inputs.target, targetNames),
    value: values,
  })
  const state = program.createState()
  state.inputs.target.set(weights)
  state.inputs.value.set(values.names.map((name, i) => inputs[name] ?? values.initial[i]))
  const resting = new Map(areas.map(({ name, activation = 0 }) => [name, activation]))
  state.resting.set(plan.areaNames.map((name) => resting.get(name) ?? 0))
  program.evaluate(state)
  const parts = partsByArea(program, state)
  return areas.map(({ name, activation = 0 }) => {
    const index = plan.areaNames.indexOf(name)
    return {
      area: name,
      activation: index < 0 ? activation : state.activations[index],
      resting: activation,
      parts: parts.get(name) ?? [],
    }
  })
}

/** Lists what each driver adds to its area, by name of the area. `state` must be evaluated. Allocates. */
export function partsByArea(program: DriverProgram, state: DriverState): Map<string, DriverPart[]> {
  const parts = new Map<string, DriverPart[]>()
  for (const [i, { driver, activation: planned }] of program.activations.entries()) {
    const { activation, links: values } = program.explain(i, state)
    const links = planned.links.map(({ input, ...link }, k) => ({
      link: { name: inputName(input), ...link } as Link,
      value: values[k],
    }))
    parts.set(planned.area, [...(parts.get(planned.area) ?? []), { driver, activation, links }])
  }
  return parts
}

/** Whether a driver reads joints or tension, which can only be measured on a moving mesh. */
export function needsMesh(driver: WrinkleDriver): boolean {
  const { joint, tension } = planDrivers([driver]).inputs
  return joint.length + tension.length > 0
}
