import { inputName } from './activation.ts'
import type { Link } from './link.ts'
import { planDrivers } from './plan.ts'
import { DriverProgram, type DriverState } from './program.ts'
import type { WrinkleDriver } from './registry.ts'
import { targetSource, valueSource } from './sources.ts'

/** A link of a driver (an input with weight and curve), and its result. */
export interface LinkPart {
  link: Link
  /** Result of the link: `weight * curve(input)`. The driver's rule combines the results of all links. */
  value: number
}

/** Contribution of one driver to the activation of an area. */
export interface DriverPart {
  driver: WrinkleDriver
  /** Activation that the driver adds, 0..1. */
  activation: number
  links: LinkPart[]
}

/** Explanation of the activation of one area. */
export interface Explanation {
  /** Name of the area. */
  area: string
  /** Sum of the resting activation and the activations of all drivers, clamped to 1. A driver of type `time` delays changes of this sum. */
  activation: number
  /** Activation of the resting face, 0..1. */
  resting: number
  /** Contributions of the drivers, in evaluation order. */
  parts: DriverPart[]
}

/** State of a face: blendshape weights and other inputs. */
export interface Situation {
  /** Names of the mesh's blendshapes. */
  targetNames: readonly string[]
  /** Weights of the blendshapes, in the order of the names. */
  weights: ArrayLike<number>
  /** Inputs that applications set, by name, such as `age` in years. */
  inputs?: Readonly<Record<string, number>>
}

/**
 * Evaluates drivers for one state of a face, and returns the contribution of each driver and link. Drivers that read joints or tension
 * are skipped (see `needsMesh`). Drivers of type `time`, which delay activations, have no effect on the results.
 *
 * @param drivers all drivers of the face.
 * @param areas areas with resting activations, 0..1, default 0.
 * @param situation state of the face.
 * @returns one explanation per area, in the order of `areas`.
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

/**
 * Returns the contributions of drivers, by name of their area. Allocates.
 *
 * @param state state that `program` has evaluated.
 */
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

/** Whether a driver reads joints or tension. These inputs can only be measured on an animated mesh. */
export function needsMesh(driver: WrinkleDriver): boolean {
  const { joint, tension } = planDrivers([driver]).inputs
  return joint.length + tension.length > 0
}
