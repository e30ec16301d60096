import type { WrinkleSet } from 'furrow'
import { type Mesh, type MeshStandardMaterial, Scene } from 'three'
import { type Harness, squareCamera } from './harness.ts'
import { influenceDifference, type UvTransform } from './influence-difference.ts'

const PIXELS = 32

/**
 * Draws a square with wrinkles, and returns the largest error of its influence against the float64 reference.
 *
 * @param set wrinkle set whose areas have 32 x 32 texels.
 * @param activations activations of the areas.
 */
export async function influenceError(
  harness: Harness,
  mesh: Mesh,
  wrinkles: InstanceType<Harness['Wrinkles']>,
  set: WrinkleSet,
  activations: readonly number[],
  transform: UvTransform = { scale: 1, offset: [0, 0] },
) {
  const material = wrinkles.createInfluenceMaterial()
  mesh.material = material as MeshStandardMaterial
  const scene = new Scene()
  scene.add(mesh)
  const pixels = await harness.render(scene, squareCamera(), PIXELS)
  const error = influenceDifference(set, 32, activations, transform, (i) => pixels[i * 4], PIXELS)
  const dispose = () => {
    material.dispose()
    wrinkles.dispose()
    mesh.geometry.dispose()
  }
  return { error, dispose }
}
