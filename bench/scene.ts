import type { GrayImage, WrinkleSet } from 'furrow'
import {
  DirectionalLight,
  Mesh,
  type MeshPhysicalMaterial,
  PerspectiveCamera,
  Scene,
  type Vector3Tuple,
} from 'three'
import type { Face } from '../stage/face.ts'
import { frameView } from '../stage/views.ts'
import { divideAreas } from './areas.ts'

const LIGHTS: readonly Vector3Tuple[] = [
  [-1, 1.35, 0.95],
  [1.3, 0.1, 0.8],
  [1.2, 1, -1.6],
]

/** How much nearer than the stage's view from the front: the face reaches every side of the frame, from the forehead to the mouth. */
const ZOOM = 3.1
/** As many of the face's areas as the masks of the other techniques hold: its first. */
const OWN_AREAS = 8
/** Metres from the middle of head and neck up to that of the face. */
const UP = 0.025

/** Lights and a camera that looks at a face from so near that it fills the frame. */
export function createScene(face: Face, aspect: number): { scene: Scene; camera: PerspectiveCamera } {
  const scene = new Scene()
  for (const from of LIGHTS) {
    const light = new DirectionalLight(0xffffff, 1.2)
    light.position.fromArray(from)
    scene.add(light)
  }
  const camera = new PerspectiveCamera()
  camera.aspect = aspect
  frameView(face.skin, camera, 'front')
  camera.zoom = ZOOM
  camera.position.y += UP
  camera.updateProjectionMatrix()
  return { scene, camera }
}

/** The face's skin once more, with a physical material of its own; geometry and textures are shared. */
export function createSkin({ skin }: Face): Mesh {
  const material = skin.material as MeshPhysicalMaterial
  if (!material.isMeshPhysicalMaterial)
    throw new Error('bench: the skin is not physical; take faces/human.glb')
  const mesh = new Mesh(skin.geometry, material.clone())
  skin.matrixWorld.decompose(mesh.position, mesh.quaternion, mesh.scale)
  return mesh
}

/**
 * As many layers and areas as a case asks for: the file's own layer over and over, and its own areas, divided.
 *
 * @throws Error when the file carries no wrinkles, or not as images.
 */
export function createSet({ wrinkles }: Face, areas: number, layers: number): WrinkleSet {
  if (!wrinkles) throw new Error('bench: the face carries no wrinkles; take faces/human.glb')
  const [{ kind, normal }] = wrinkles.set.layers
  if ('slice' in normal) throw new Error('bench: the wrinkles are a KTX 2 array; take faces/human.glb')
  const copies = Array.from({ length: layers }, (_, i) => ({
    name: `layer${i}`,
    kind,
    normal: { ...normal, data: normal.data.slice() },
  }))
  const own = wrinkles.set.areas.slice(0, OWN_AREAS).map(({ weights }) => weights as GrayImage)
  const names = copies.map(({ name }) => name)
  return { layers: copies, areas: divideAreas(own, areas, names) }
}
