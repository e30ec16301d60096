import type { WrinkleSet } from 'furrow'
import {
  DirectionalLight,
  Mesh,
  MeshPhysicalMaterial,
  type MeshStandardMaterial,
  PerspectiveCamera,
  Scene,
  type Vector3Tuple,
} from 'three'
import type { Face } from '../stage/face.ts'
import { frameView } from '../stage/views.ts'
import { createBlobs } from './blobs.ts'

const LIGHTS: readonly Vector3Tuple[] = [
  [-1, 1.35, 0.95],
  [1.3, 0.1, 0.8],
  [1.2, 1, -1.6],
]

/** How much nearer than the stage's close view: the skin reaches every side of the frame. */
const ZOOM = 2

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
  frameView(face.skin, camera, 'close')
  camera.zoom = ZOOM
  camera.updateProjectionMatrix()
  return { scene, camera }
}

/** The face's skin once more, with a physical material of its own; geometry and textures are shared. */
export function createSkin({ skin }: Face): Mesh {
  const { map, normalMap, normalScale, roughnessMap, roughness } = skin.material as MeshStandardMaterial
  const material = new MeshPhysicalMaterial({ map, normalMap, roughnessMap, roughness, metalness: 0 })
  material.normalScale.copy(normalScale)
  const mesh = new Mesh(skin.geometry, material)
  skin.matrixWorld.decompose(mesh.position, mesh.quaternion, mesh.scale)
  return mesh
}

/**
 * As many layers and areas as a case asks for: the file's own layer over and over, and blobs on the front of the face.
 *
 * @throws Error when the file carries no wrinkles, or not as images.
 */
export function createSet({ skin, wrinkles }: Face, areas: number, layers: number): WrinkleSet {
  if (!wrinkles) throw new Error('bench: the face carries no wrinkles; take faces/human.glb')
  const [{ kind, normal }] = wrinkles.set.layers
  if ('slice' in normal) throw new Error('bench: the wrinkles are a KTX 2 array; take faces/human.glb')
  const copies = Array.from({ length: layers }, (_, i) => ({
    name: `layer${i}`,
    kind,
    normal: { ...normal, data: normal.data.slice() },
  }))
  const names = copies.map(({ name }) => name)
  return { layers: copies, areas: createBlobs(areas, frontPlaces(skin), names) }
}

/** UVs of the vertices that look forwards. */
function frontPlaces({ geometry }: Mesh): Float32Array {
  const { uv, normal } = geometry.attributes
  const places: number[] = []
  for (let i = 0; i < uv.count; i++) if (normal.getZ(i) > 0.5) places.push(uv.getX(i), uv.getY(i))
  return Float32Array.from(places)
}
