import { MeshoptSimplifier } from 'meshoptimizer'
import { InstancedMesh, type Material, Matrix4 } from 'three'
import type { Plan } from './case.ts'
import { applyFurrow } from './furrow.ts'
import type { Bench } from './measure.ts'
import { createSet, createSkin } from './scene.ts'
import { ratio } from './statistics.ts'

export const FACES = 1000
/** Areas per face, all of which move. */
const AREAS = 8
/** Width and height of the areas in texels, as in examples/crowd.html: more than a face's width in pixels. */
const AREA_SIZE = 64
/** Blendshapes per face that are not at rest, as many as an expression has. */
const MOVING = 6
/** Fraction of its triangles that a face keeps: it is only a few dozen pixels high. */
const TRIANGLE_FRACTION = 0.06

/**
 * Fraction of a frame with a crowd, 0..1, that goes into the faces' influence maps: compares frames in which all areas of all
 * faces move with frames in which none does.
 */
export async function measureCrowd(
  { face, scene, camera, timedRenderer, renderer }: Bench,
  plan: Plan,
): Promise<number> {
  await MeshoptSimplifier.ready
  const skin = createSkin(face)
  const geometry = skin.geometry.clone()
  const triangles = Uint32Array.from(geometry.index!.array)
  const positions = geometry.getAttribute('position').array as Float32Array
  const indexCount = 3 * Math.floor((triangles.length / 3) * TRIANGLE_FRACTION)
  geometry.setIndex([...MeshoptSimplifier.simplify(triangles, positions, 3, indexCount, 1)[0]])
  const crowd = new InstancedMesh(geometry, skin.material, FACES)
  crowd.frustumCulled = false
  const targets = skin.morphTargetInfluences!
  const columns = Math.ceil(Math.sqrt(FACES))
  for (let i = 0; i < FACES; i++) {
    const matrix = new Matrix4().setPosition(
      (i % columns) / columns - 0.5,
      Math.floor(i / columns) / columns - 0.5,
      0,
    )
    crowd.setMatrixAt(i, matrix.multiply(new Matrix4().makeScale(0.12, 0.12, 0.12)))
  }
  crowd.position.copy(camera.position).setZ(0)
  crowd.scale.setScalar(0.2)
  scene.add(crowd)
  const wrinkles = applyFurrow(crowd, createSet(face, AREAS, 1), renderer, {
    areaSize: AREA_SIZE,
  })
  let [areaFrame, frame] = [0, 0]
  const time = async (isMoving: boolean) => {
    if (isMoving) areaFrame++
    frame++
    for (let i = 0; i < FACES; i++) {
      // Blendshapes move in both kinds of frames, so that only the influence maps differ.
      for (let k = 0; k < MOVING; k++) targets[k] = 0.5 + 0.5 * Math.sin(frame * 0.3 + i + k)
      crowd.setMorphAt(i, skin)
      for (let area = 0; area < AREAS; area++) {
        wrinkles.setActivation(`area${area}`, 0.55 + 0.45 * Math.sin(areaFrame * 0.37 + area * 2.4 + i), i)
      }
    }
    crowd.morphTexture!.needsUpdate = true
    return timedRenderer.time(() => timedRenderer.draw(scene, camera))
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
