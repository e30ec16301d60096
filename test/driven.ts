import type { WrinkleDriver } from 'furrow'
import { DriverProgram, planDrivers, targetSource, valueSource } from 'furrow/internal'

/** Prepares drivers that read blendshapes and named inputs, to evaluate them without an engine. */
export function driven(drivers: readonly WrinkleDriver[], targetNames: readonly string[] = []) {
  const plan = planDrivers(drivers)
  const values = valueSource(plan.inputs.value)
  const program = new DriverProgram(plan, {
    target: targetSource(plan.inputs.target, targetNames),
    value: values,
  })
  const state = program.createState()
  return {
    plan,
    missing: program.missing,
    /** Evaluates the drivers and returns the activation of each area by name. */
    activations({
      weights = [],
      inputs = {},
      resting = {},
      seconds = 0,
    }: {
      weights?: ArrayLike<number>
      inputs?: Record<string, number>
      resting?: Record<string, number>
      seconds?: number
    } = {}): Record<string, number> {
      state.inputs.target.set(weights)
      state.inputs.value.set(values.names.map((name, i) => inputs[name] ?? values.initial[i]))
      state.resting.set(plan.areaNames.map((name) => resting[name] ?? 0))
      state.seconds[0] = seconds
      program.evaluate(state)
      return Object.fromEntries(plan.areaNames.map((name, i) => [name, state.activations[i]]))
    },
  }
}
