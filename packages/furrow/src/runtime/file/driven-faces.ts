import { targetFinder } from '../../drivers/morph/target-names.ts'
import { planDrivers } from '../../drivers/plan.ts'
import type { WrinkleDriver } from '../../drivers/registry.ts'

/** Measures by which a mesh counts as a face. */
export interface FaceMeasure {
  /** Names of its blendshapes. */
  targets: readonly string[]
  vertices: number
}

/** Fraction of the blendshapes on the best mesh that another one has at least, if it is a face too. */
const LEAST_SHAPES = 0.5

/**
 * Chooses the faces among meshes that share a material with wrinkles: those with the blendshapes that its drivers read. Eyes, teeth and hands
 * are often drawn with the material of the skin.
 *
 * @returns the faces, the one with most of these blendshapes first; all meshes where none has any.
 */
export function drivenFaces<T>(
  meshes: readonly T[],
  measure: (mesh: T) => FaceMeasure,
  drivers: readonly WrinkleDriver[],
): T[] {
  if (meshes.length < 2) return [...meshes]
  const wanted = [...new Set(planDrivers(drivers).inputs.target.map(({ name }) => name))]
  const found = meshes.map((mesh) => {
    const { targets, vertices } = measure(mesh)
    const find = targetFinder(targets)
    return { mesh, vertices, shapes: wanted.filter((name) => find(name).length > 0).length }
  })
  const most = Math.max(...found.map(({ shapes }) => shapes))
  if (most === 0) return [...meshes]
  return found
    .filter(({ shapes }) => shapes >= LEAST_SHAPES * most)
    .sort((a, b) => b.shapes - a.shapes || b.vertices - a.vertices)
    .map(({ mesh }) => mesh)
}
