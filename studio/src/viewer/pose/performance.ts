import { driversOf, type Expression, type WrinkleDriver } from 'furrow'
import { canonicalTargetName, explain } from 'furrow/internal'

/** Minimum activation at which a pose counts as showing an area. */
const MIN_VISIBLE = 0.2

/** Pose that shows an area or a blendshape. */
export interface Performance {
  /** Weights of blendshapes. All other blendshapes have 0. */
  readonly targets: ReadonlyMap<string, number>
  /** Activations of areas that an expression sets directly. */
  readonly activations: ReadonlyMap<string, number>
}

/** Returns the pose of a single blendshape. */
export function poseOfTarget(name: string): Performance {
  return { targets: new Map([[canonicalTargetName(name), 1]]), activations: new Map() }
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
  const names = targetNames.map(canonicalTargetName)
  const driven = (targets: ReadonlyMap<string, number>) => {
    const weights = names.map((name) => targets.get(name) ?? 0)
    return explain(drivers, [{ name: area }], { targetNames, weights })[0].activation
  }
  const own = driversOf('morph', drivers).flatMap((driver) => (driver.area === area ? driver.targets : []))
  const read = new Map(own.map(({ name }) => [canonicalTargetName(name), 1]))
  const performances = expressions.map(({ targets, activations }) => ({
    targets: new Map(Object.entries(targets).map(([name, weight]) => [canonicalTargetName(name), weight])),
    activations: new Map(Object.entries(activations)),
  }))
  const shown = performances
    .map((performance) => {
      const activation = Math.max(performance.activations.get(area) ?? 0, driven(performance.targets))
      return { performance, activation }
    })
    .toSorted((a, b) => b.activation - a.activation)
  const [best] = shown
  if (best && best.activation >= MIN_VISIBLE) return best.performance
  return driven(read) >= MIN_VISIBLE ? { targets: read, activations: new Map() } : null
}
