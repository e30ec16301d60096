import { findTargets } from 'furrow'
import { WrinkleLoaderPlugin as WebGLPlugin, wrinklesOf } from 'furrow/three'
import { WrinkleLoaderPlugin as WebGPUPlugin } from 'furrow/webgpu'
import type { Mesh } from 'three'
import { MeshoptDecoder } from 'three/addons/libs/meshopt_decoder.module.js'
import { DRACOLoader } from 'three/addons/loaders/DRACOLoader.js'
import { type GLTF, GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'
import { inject } from 'vitest'
import { faceScene, HEIGHT, WIDTH } from './face.ts'
import type { Harness } from './harness.ts'

const draco = new DRACOLoader().setDecoderPath('/node_modules/three/examples/jsm/libs/draco/gltf/')

/** Blendshape weights. */
const POSE = { browInnerUp: 1, browOuterUpLeft: 1, mouthSmileLeft: 1, mouthSmileRight: 1, cheekSquintLeft: 1 }

/** Loads one of the files of `pack-faces.ts` with its wrinkles. */
export function loadPacked(harness: Harness, file: string, loader = new GLTFLoader()): Promise<GLTF> {
  const Plugin = harness.name === 'webgl' ? WebGLPlugin : WebGPUPlugin
  return loader
    .setMeshoptDecoder(MeshoptDecoder)
    .setDRACOLoader(draco)
    .register((parser) => new Plugin(parser))
    .loadAsync(`${inject('packedFaces')}/${file}.glb`)
}

/** The posed face with wrinkles, without them, or their influence as gray. */
export async function posedPicture(harness: Harness, gltf: GLTF, mode: 'default' | 'off' | 'influence') {
  const skin = skinOf(gltf)
  const wrinkles = wrinklesOf(skin)!
  const targets = Object.keys(skin.morphTargetDictionary!)
  for (const [name, weight] of Object.entries(POSE)) {
    for (const index of findTargets(name, targets)) skin.morphTargetInfluences![index] = weight
  }
  const { scene, camera } = faceScene({ root: gltf.scene, skin, wrinkles: null }, 'front')
  const original = skin.material
  if (mode === 'influence') skin.material = wrinkles.createInfluenceMaterial()
  wrinkles.mode = mode === 'off' ? 'off' : 'default'
  const pixels = await harness.render(scene, camera, WIDTH, HEIGHT)
  skin.material = original
  return pixels
}

function skinOf(gltf: GLTF): Mesh {
  let skin: Mesh | undefined
  gltf.scene.traverse((object) => {
    if (wrinklesOf(object as Mesh)) skin ??= object as Mesh
  })
  return skin!
}

/** Compares the effects of wrinkles in pictures of two faces; equal effects have correlation 1 and ratio of strengths 1. */
export async function compareWrinkles(harness: Harness, one: GLTF, other: GLTF) {
  const [a, b] = [await wrinkleEffect(harness, one), await wrinkleEffect(harness, other)]
  const [strength, otherStrength] = [dot(a, a), dot(b, b)]
  return {
    strength,
    correlation: dot(a, b) / Math.sqrt(strength * otherStrength),
    ratio: Math.sqrt(otherStrength / strength),
  }
}

async function wrinkleEffect(harness: Harness, gltf: GLTF): Promise<Float32Array> {
  const smooth = await posedPicture(harness, gltf, 'off')
  return (await posedPicture(harness, gltf, 'default')).map((value, i) => value - smooth[i])
}

function dot(a: Float32Array, b: Float32Array): number {
  return a.reduce((sum, value, i) => sum + value * b[i], 0)
}
