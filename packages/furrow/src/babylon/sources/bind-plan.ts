import type { Scene } from '@babylonjs/core/scene.js'
import type { InputOf } from '../../drivers/activation.ts'
import { expressionsOf } from '../../drivers/expression/expression.ts'
import type { DriverPlan } from '../../drivers/plan.ts'
import type { WrinkleDriver } from '../../drivers/registry.ts'
import { DriverRuntime, type InputReader, type MeasuredKind } from '../../runtime/driver-runtime.ts'
import type { WrinklesBase } from '../wrinkles-base.ts'

/** Finds inputs of one kind on a mesh. */
export type BindInputs<K extends MeasuredKind> = (
  wrinkles: WrinklesBase,
  inputs: readonly InputOf<K>[],
) => InputReader<Scene>

/** How each kind of input is read. Drivers that read others are left out. */
export type InputBindings = { readonly [K in MeasuredKind]?: BindInputs<K> }

/** Drivers in the order in which they run, and the ways to read their inputs: shared by all faces that have these drivers. */
export interface PlannedDrivers {
  readonly drivers: readonly WrinkleDriver[]
  readonly plan: DriverPlan
  /** At least those of the kinds of input that the plan has. */
  readonly bindings: InputBindings
}

/** Lets drivers activate areas, of copies of the face too. Muscles must have been added to the mesh. */
export function bindPlan(wrinkles: WrinklesBase, planned: PlannedDrivers): void {
  const { drivers, plan, bindings } = planned
  const { target, joint, tension } = bindings
  const { inputs } = plan
  const bind = () => ({
    ...(target && { target: target(wrinkles, inputs.target) }),
    ...(joint && { joint: joint(wrinkles, inputs.joint) }),
    ...(tension && { tension: tension(wrinkles, inputs.tension) }),
  })
  const runtime = new DriverRuntime<Scene>(
    plan,
    bind,
    wrinkles.inputs,
    wrinkles.faceCount,
    wrinkles.mesh.name,
  )
  wrinkles.expressions = expressionsOf(drivers)
  wrinkles.setDrivers(runtime)
  wrinkles.copyDrivers = (copy) => bindPlan(copy, planned)
  runtime.bind()
}
