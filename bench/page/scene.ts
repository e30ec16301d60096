import type { GrayImage, Layer, WrinkleSet } from 'furrow'
import {
  DirectionalLight,
  HemisphereLight,
  Mesh,
  type MeshPhysicalMaterial,
  PerspectiveCamera,
  Scene,
} from 'three'
import type { Face } from '../../stage/face.ts'
import { frameView } from '../../stage/views.ts'
import type { Case } from '../case.ts'
import { divideAreas } from './areas.ts'
import type { Bench } from './bench.ts'
import { LIGHT_INTENSITY, LIGHTS } from './lights.ts'

/** Zoom of the camera, relative to the front view of `stage/views.ts`. The picture then shows the face from forehead to mouth. */
const ZOOM = 3.1
/** Number of the face's areas to use. The variants `jimenez` and `o3de` support at most eight masks. */
const ORIGINAL_AREAS = 8
/** Height of the face's centre above the centre of head and neck, metres. */
const CAMERA_RISE = 0.025

export function createScene(face: Face, aspect: number): Pick<Bench, 'scene' | 'camera' | 'ambient'> {
  const scene = new Scene()
  for (const from of LIGHTS) {
    const light = new DirectionalLight(0xffffff, LIGHT_INTENSITY)
    light.position.set(...from)
    scene.add(light)
  }
  const ambient = new HemisphereLight(0xffffff, 0x664433, 0.6)
  scene.add(ambient)
  const camera = new PerspectiveCamera()
  camera.aspect = aspect
  frameView(face.skin, camera, 'front')
  camera.zoom = ZOOM
  camera.position.y += CAMERA_RISE
  camera.updateProjectionMatrix()
  return { scene, camera, ambient }
}

/** Creates a mesh of the face's skin with a cloned material. The mesh shares geometry and textures with the face. */
export function createSkin({ skin }: Face): Mesh {
  const material = skin.material as MeshPhysicalMaterial
  if (!material.isMeshPhysicalMaterial)
    throw new Error('bench: the material of the skin is not physical; use faces/human.glb')
  const mesh = new Mesh(skin.geometry, material.clone())
  skin.matrixWorld.decompose(mesh.position, mesh.quaternion, mesh.scale)
  return mesh
}

/**
 * Creates the wrinkle set of a benchmark case. Its layers are copies of the face's first layer, and `divideAreas` creates its areas.
 *
 * @throws Error if the face has no wrinkles, or stores their maps as a KTX 2 array.
 */
export function createSet(
  { wrinkles }: Face,
  { areas, layers, maps }: Pick<Case, 'areas' | 'layers' | 'maps'>,
): WrinkleSet {
  if (!wrinkles) throw new Error('bench: the face has no wrinkles; use faces/human.glb')
  const [{ kind, normal, occlusion, blood, bloodAmplitude }] = wrinkles.set.layers as Layer[]
  if ('slice' in normal) throw new Error('bench: the wrinkles are a KTX 2 array; use faces/human.glb')
  const copies = Array.from({ length: layers }, (_, i) => ({
    name: `layer${i}`,
    kind,
    normal: { ...normal, data: normal.data.slice() },
    ...(maps !== 'normals' && { occlusion, blood, bloodAmplitude }),
    ...(maps === 'onset' && { onset: onsetOf(occlusion as GrayImage) }),
  }))
  const originals = wrinkles.set.areas.slice(0, ORIGINAL_AREAS).map(({ weights }) => weights as GrayImage)
  const names = copies.map(({ name }) => name)
  return { layers: copies, areas: divideAreas(originals, areas, names) }
}

/** Creates an onset map from an occlusion map. Wrinkles are deepest where the occlusion map is dark, so they appear there at the lowest influence. */
function onsetOf({ width, height, data }: GrayImage): GrayImage {
  return { width, height, data: data.map((value) => value / 2) }
}
