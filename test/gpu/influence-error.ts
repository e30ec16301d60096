import { packAreas, reference, type WrinkleSet } from 'furrow'
import { type Mesh, type MeshStandardMaterial, Scene } from 'three'
import { type Harness, squareCamera } from './harness.ts'

const PIXELS = 32

/** The square's texture coordinates, see `square`. */
interface UvTransform {
  scale: number
  offset: readonly number[]
}

/**
 * Largest error over the pixels of a square of the wrinkles' influence against the float64 reference.
 *
 * @param set with areas of 32 x 32 texels.
 * @param activations of the areas when the square is drawn.
 */
export async function influenceError(
  harness: Harness,
  mesh: Mesh,
  wrinkles: InstanceType<Harness['Wrinkles']>,
  set: WrinkleSet,
  activations: readonly number[],
  { scale, offset }: UvTransform = { scale: 1, offset: [0, 0] },
) {
  const material = wrinkles.createInfluenceMaterial()
  mesh.material = material as MeshStandardMaterial
  const scene = new Scene()
  scene.add(mesh)
  const pixels = await harness.render(scene, squareCamera(), PIXELS)
  const areas = packAreas(
    set.areas.map(({ weights }) => weights),
    32,
  )
  const table = set.areas.map(({ combine = 'sum' }, i) => ({ activation: activations[i], layer: 0, combine }))
  let error = 0
  for (let y = 0; y < PIXELS; y++) {
    for (let x = 0; x < PIXELS; x++) {
      const u = ((x + 0.5) / PIXELS) * scale + offset[0]
      const v = (1 - (y + 0.5) / PIXELS) * scale + offset[1]
      const exact = reference.influenceFromMap(areas, table, u, v)
      error = Math.max(error, Math.abs(pixels[(y * PIXELS + x) * 4] - exact))
    }
  }
  const dispose = () => {
    material.dispose()
    wrinkles.dispose()
    mesh.geometry.dispose()
  }
  return { error, dispose }
}
