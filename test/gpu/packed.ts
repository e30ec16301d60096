import { findTargets } from 'furrow'
import { wrinklesOf } from 'furrow/three'
import type { Mesh } from 'three'
import { MeshoptDecoder } from 'three/addons/libs/meshopt_decoder.module.js'
import { DRACOLoader } from 'three/addons/loaders/DRACOLoader.js'
import { type GLTF, GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'
import { faceScene, HEIGHT, WIDTH } from './face.ts'
import type { Harness } from './harness.ts'

const draco = new DRACOLoader().setDecoderPath('/node_modules/three/examples/jsm/libs/draco/gltf/')

/** Blendshape weights of the pose that pictures show. */
const POSE = { browInnerUp: 1, browOuterUpLeft: 1, mouthSmileLeft: 1, mouthSmileRight: 1, cheekSquintLeft: 1 }

/** Loads a face made by `pack-faces.ts`, with its wrinkles. */
export function loadPacked({ Plugin }: Harness, file: string, loader = new GLTFLoader()): Promise<GLTF> {
  return loader
    .setMeshoptDecoder(MeshoptDecoder)
    .setDRACOLoader(draco)
    .register((parser) => new Plugin(parser))
    .loadAsync(`/packed/${file}.glb`)
}

/** Renders the face in `POSE`: with wrinkles, without wrinkles, or with its influence as gray. */
export async function posedPicture(harness: Harness, gltf: GLTF, mode: 'default' | 'off' | 'influence') {
  const skin = skinOf(gltf)
  const wrinkles = wrinklesOf(skin)!
  const targets = Object.keys(skin.morphTargetDictionary!)
  for (const [name, weight] of Object.entries(POSE)) {
    for (const index of findTargets(name, targets)) skin.morphTargetInfluences![index] = weight
  }
  const { scene, camera } = faceScene({ root: gltf.scene, skin }, 'front')
  const own = skin.material
  if (mode === 'influence') skin.material = wrinkles.createInfluenceMaterial()
  wrinkles.mode = mode === 'off' ? 'off' : 'default'
  const pixels = await harness.render(scene, camera, WIDTH, HEIGHT)
  skin.material = own
  return pixels
}

function skinOf(gltf: GLTF): Mesh {
  const meshes = gltf.scene.getObjectsByProperty('isMesh', true) as Mesh[]
  return meshes.find((mesh) => wrinklesOf(mesh))!
}

/** Returns the picture of a face with wrinkles minus the picture without them. */
export async function wrinklesAlone(harness: Harness, gltf: GLTF): Promise<Float32Array> {
  const smooth = await posedPicture(harness, gltf, 'off')
  return (await posedPicture(harness, gltf, 'default')).map((value, i) => value - smooth[i])
}

/** Compares two results of `wrinklesAlone`: correlation, and `ratio` of their strengths; both are 1 for equal faces. */
export function compareWrinkles(a: Float32Array, b: Float32Array) {
  const [own, others] = [dot(a, a), dot(b, b)]
  return { strength: own, correlation: dot(a, b) / Math.sqrt(own * others), ratio: Math.sqrt(others / own) }
}

function dot(a: Float32Array, b: Float32Array): number {
  return a.reduce((sum, value, i) => sum + value * b[i], 0)
}
