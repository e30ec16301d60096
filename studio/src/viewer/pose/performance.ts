import { driversOf, type Expression, type WrinkleDriver } from 'furrow'
import { canonicalTargetName, explain } from 'furrow/internal'

/** Activation from which on an expression shows an area. */
const SHOWN = 0.2

/** A pose that shows an area or a blendshape: weights of blendshapes, all others 0, and activations of areas that an expression sets itself. */
export interface Performance {
  readonly targets: ReadonlyMap<string, number>
  readonly activations: ReadonlyMap<string, number>
}

/** The pose of one blendshape alone. */
export function poseOfTarget(name: string): Performance {
  return { targets: new Map([[canonicalTargetName(name), 1]]), activations: new Map() }
}

/**
 * Finds the expression that drives an area most; where none does, the blendshapes that its drivers read, fully set.
 *
 * @param drivers of the face; joints, tension and the application's inputs are left as they rest.
 * @param targetNames of the face's blendshapes.
 * @returns null where no blendshape shows the area.
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
  if (best && best.activation >= SHOWN) return best.performance
  return driven(read) >= SHOWN ? { targets: read, activations: new Map() } : null
}
