import { inputName } from './activation.ts'
import type { Link } from './link.ts'
import { planDrivers } from './plan.ts'
import { DriverProgram } from './program.ts'
import type { WrinkleDriver } from './registry.ts'
import { targetSource, valueSource } from './sources.ts'

/** What one link gives to its driver, before the driver's rule and curve. */
export interface LinkPart {
  link: Link
  value: number
}

/** What one driver gives to an area. */
export interface Part {
  driver: WrinkleDriver
  /** 0..1; all of an area's and its activation at rest add up to at most 1. */
  activation: number
  links: LinkPart[]
}

/** Why an area shows. */
export interface Explanation {
  area: string
  activation: number
  resting: number
  parts: Part[]
}

/** What the drivers are asked about. */
export interface Situation {
  /** Names of the mesh's blendshapes, and their weights in the same order. */
  targetNames: readonly string[]
  weights: ArrayLike<number>
  /** What the application sets, by name, such as `age` in years. */
  inputs?: Readonly<Record<string, number>>
}

/**
 * Says of each area how much of it shows and which link gave it, as far as blendshapes, the application's inputs and other areas
 * decide; joints and tension need the moving mesh. Delays are left out: the result is where the face comes to rest.
 *
 * @param areas with their activations at rest.
 */
export function explain(
  drivers: readonly WrinkleDriver[],
  areas: readonly { name: string; activation?: number }[],
  { targetNames, weights, inputs = {} }: Situation,
): Explanation[] {
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

/** Whether a driver reads what only the moving mesh tells: joints or tension. */
export function needsMesh(driver: WrinkleDriver): boolean {
  const { joint, tension } = planDrivers([driver]).inputs
  return joint.length + tension.length > 0
}
