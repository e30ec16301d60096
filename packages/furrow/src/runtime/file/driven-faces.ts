import { targetFinder } from '../../drivers/morph/target-names.ts'
import { planDrivers } from '../../drivers/plan.ts'
import type { WrinkleDriver } from '../../drivers/registry.ts'

export interface FaceMeasure {
  /** Names of the mesh's blendshapes. */
  targets: readonly string[]
  vertices: number
}

/** Minimum number of driven blendshapes on a face, as a fraction of the largest number on any mesh. */
const MIN_SHAPES = 0.5

/**
 * Finds the faces among meshes that share a wrinkled material. Eyes, teeth and hands often have this material too. Drivers activate wrinkles
 * by blendshapes, so the faces are the meshes with the most blendshapes that drivers of the material read.
 *
 * @returns the faces, sorted by number of driven blendshapes, largest first. If no mesh has a driven blendshape, returns all meshes.
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
    .filter(({ shapes }) => shapes >= MIN_SHAPES * most)
    .sort((a, b) => b.shapes - a.shapes || b.vertices - a.vertices)
    .map(({ mesh }) => mesh)
}
