import { MeshoptSimplifier } from 'meshoptimizer'
import { InstancedMesh, type Material, Matrix4 } from 'three'
import type { Plan } from './case.ts'
import { wearFurrow } from './furrow.ts'
import type { Bench } from './measure.ts'
import { createSet, createSkin } from './scene.ts'
import { ratio } from './statistics.ts'

export const FACES = 1000
/** Areas of each face, all of which move. */
const AREAS = 8
/** Side of the areas, as in examples/crowd.html: a face is not even as many pixels wide. */
const AREA_SIZE = 64
/** Blendshapes of each face that are not at rest, as many as an expression has. */
const MOVING = 6
/** Share of its triangles that a face keeps: each is a few dozen pixels high. */
const DETAIL = 0.06

/**
 * Share of a frame with a crowd, of which every face has activations of its own, that goes into its influence maps, 0..1: how much
 * longer frames take in which all areas of all faces move than frames in which none does.
 */
export async function measureCrowd(
  { face, scene, camera, drawer, renderer }: Bench,
  plan: Plan,
): Promise<number> {
  await MeshoptSimplifier.ready
  const skin = createSkin(face)
  const geometry = skin.geometry.clone()
  const triangles = Uint32Array.from(geometry.index!.array)
  const positions = geometry.getAttribute('position').array as Float32Array
  const few = 3 * Math.floor((triangles.length / 3) * DETAIL)
  geometry.setIndex([...MeshoptSimplifier.simplify(triangles, positions, 3, few, 1)[0]])
  const crowd = new InstancedMesh(geometry, skin.material, FACES)
  crowd.frustumCulled = false
  const targets = skin.morphTargetInfluences!
  const columns = Math.ceil(Math.sqrt(FACES))
  for (let i = 0; i < FACES; i++) {
    const place = new Matrix4().setPosition(
      (i % columns) / columns - 0.5,
      Math.floor(i / columns) / columns - 0.5,
      0,
    )
    crowd.setMatrixAt(i, place.multiply(new Matrix4().makeScale(0.12, 0.12, 0.12)))
  }
  crowd.position.copy(camera.position).setZ(0)
  crowd.scale.setScalar(0.2)
  scene.add(crowd)
  const wrinkles = wearFurrow(crowd, createSet(face, AREAS, 1), renderer, {
    areaSize: AREA_SIZE,
  })
  let [frame, moved] = [0, 0]
  const time = async (isMoving: boolean) => {
    if (isMoving) frame++
    moved++
    for (let i = 0; i < FACES; i++) {
      // Blendshapes move in both kinds of frames: the faces are what they are for.
      for (let k = 0; k < MOVING; k++) targets[k] = 0.5 + 0.5 * Math.sin(moved * 0.3 + i + k)
      crowd.setMorphAt(i, skin)
      for (let area = 0; area < AREAS; area++) {
        wrinkles.setActivation(`area${area}`, 0.55 + 0.45 * Math.sin(frame * 0.37 + area * 2.4 + i), i)
      }
    }
    crowd.morphTexture!.needsUpdate = true
    return drawer.time(() => drawer.draw(scene, camera))
  }
  await time(true)
  const [still, moving]: number[][] = [[], []]
  for (let round = 0; round < plan.rounds; round++) {
    still.push(await time(false))
    moving.push(await time(true))
  }
  wrinkles.dispose()
  scene.remove(crowd)
  geometry.dispose()
  ;(skin.material as Material).dispose()
  return 1 - ratio(still, moving)
}
