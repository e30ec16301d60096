import { driversOf, type Expression, type WrinkleDriver } from 'furrow'
import { canonicalTargetName, explain } from 'furrow/internal'
import type { JointRotations } from './interpolate.ts'

/** Minimum activation at which a pose counts as showing an area. */
const MIN_VISIBLE = 0.2

/** Pose that shows an area or a blendshape. */
export interface Performance {
  /** Weights of blendshapes. All other blendshapes have 0. */
  readonly targets: ReadonlyMap<string, number>
  /** Activations of areas that an expression sets directly. */
  readonly activations: ReadonlyMap<string, number>
  /** Rotations of joints that fold the area. Other joints stay as they are. */
  readonly joints?: JointRotations
}

/** Returns the pose of a single blendshape. */
export function poseOfTarget(name: string): Performance {
  return { targets: new Map([[canonicalTargetName(name), 1]]), activations: new Map() }
}

/** Expression that shows an area, with the activation that it gives. */
export interface ShowingExpression {
  readonly name: string
  readonly activation: number
  readonly performance: Performance
}

/**
 * Returns the expressions that activate an area visibly, the strongest first.
 *
 * @param drivers drivers of the face. Joints, tension and custom inputs stay at rest.
 * @param targetNames blendshapes of the face.
 */
export function expressionsShowing(
  area: string,
  drivers: readonly WrinkleDriver[],
  expressions: readonly Expression[],
  targetNames: readonly string[],
): readonly ShowingExpression[] {
  const driven = activationBy(area, drivers, targetNames)
  return expressions
    .map(({ name, targets, activations }) => {
      const weights = Object.entries(targets).map(
        ([target, weight]) => [canonicalTargetName(target), weight] as const,
      )
      const performance = { targets: new Map(weights), activations: new Map(Object.entries(activations)) }
      const activation = Math.max(activations[area] ?? 0, driven(performance.targets))
      return { name, activation, performance }
    })
    .filter(({ activation }) => activation >= MIN_VISIBLE)
    .toSorted((a, b) => b.activation - a.activation)
}

/**
 * Returns the pose of the expression that activates an area most. If no expression activates the area, returns the pose in which all
 * blendshapes that the area's drivers read have the weight 1.
 *
 * @param drivers drivers of the face. Joints, tension and custom inputs stay at rest.
 * @param targetNames blendshapes of the face.
 * @returns null if no blendshape shows the area.
 */
export function performanceOf(
  area: string,
  drivers: readonly WrinkleDriver[],
  expressions: readonly Expression[],
  targetNames: readonly string[],
): Performance | null {
  const [best] = expressionsShowing(area, drivers, expressions, targetNames)
  if (best) return best.performance
  const own = driversOf('morph', drivers).flatMap((driver) => (driver.area === area ? driver.targets : []))
  const read = new Map(own.map(({ name }) => [canonicalTargetName(name), 1]))
  const activation = activationBy(area, drivers, targetNames)(read)
  return activation >= MIN_VISIBLE ? { targets: read, activations: new Map() } : null
}

/** Returns a function that computes the activation of an area from the weights of blendshapes. */
function activationBy(
  area: string,
  drivers: readonly WrinkleDriver[],
  targetNames: readonly string[],
): (targets: ReadonlyMap<string, number>) => number {
  const names = targetNames.map(canonicalTargetName)
  return (targets) => {
    const weights = names.map((name) => targets.get(name) ?? 0)
    return explain(drivers, [{ name: area }], { targetNames, weights })[0].activation
  }
}
