import { inputName } from './activation.ts'
import type { Link } from './link.ts'
import { planDrivers } from './plan.ts'
import { DriverProgram } from './program.ts'
import type { WrinkleDriver } from './registry.ts'
import { targetSource, valueSource } from './sources.ts'

/** What one link contributes to its driver. */
export interface LinkPart {
  link: Link
  /** Before the driver's rule and curve. */
  value: number
}

/** What one driver adds to an area. */
export interface Part {
  driver: WrinkleDriver
  /** 0..1; the sum over an area's drivers and its activation at rest is clamped to 1. */
  activation: number
  /** In the order of the driver. */
  links: LinkPart[]
}

/** Where the activation of an area comes from. */
export interface Explanation {
  /** Name of the area. */
  area: string
  /** 0..1. */
  activation: number
  /** Activation at rest, 0..1. */
  resting: number
  /** Its drivers, in the order they run in. */
  parts: Part[]
}

/** The state of a face that `explain` is asked about. */
export interface Situation {
  /** Names of the mesh's blendshapes. */
  targetNames: readonly string[]
  /** Their weights, in the same order. */
  weights: ArrayLike<number>
  /** Numbers that the application sets by name, such as `age` in years. */
  inputs?: Readonly<Record<string, number>>
}

/**
 * Evaluates drivers for one state of a face, and tells what each link contributes. Drivers of joints and tension are left out
 * (`needsMesh`), as are delays: the result is what the activations converge to.
 *
 * @param drivers all drivers of the face.
 * @param areas with their activations at rest, 0..1, 0 by default.
 * @param situation weights of blendshapes, and the application's inputs.
 * @returns one explanation for each area, in their order.
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
  const parts = program.activations.map(({ driver, activation: { area, links } }, i) => {
    const { activation, links: values } = program.explain(i, state)
    const linkParts = links.map(({ input, ...link }, k) => ({
      link: { name: inputName(input), ...link } as Link,
      value: values[k],
    }))
    return { area, part: { driver, activation, links: linkParts } }
  })
  return areas.map(({ name, activation = 0 }) => {
    const index = plan.areaNames.indexOf(name)
    return {
      area: name,
      activation: index < 0 ? activation : state.activations[index],
      resting: activation,
      parts: parts.filter(({ area }) => area === name).map(({ part }) => part),
    }
  })
}

/** Whether a driver reads inputs that can only be measured on the moving mesh: joints or tension. */
export function needsMesh(driver: WrinkleDriver): boolean {
  const { joint, tension } = planDrivers([driver]).inputs
  return joint.length + tension.length > 0
}
