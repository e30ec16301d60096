import type { AssetContainer } from '@babylonjs/core/assetContainer.js'
import type { FreeCamera } from '@babylonjs/core/Cameras/freeCamera.js'
import { LoadAssetContainerAsync } from '@babylonjs/core/Loading/sceneLoader.js'
import type { PBRMaterial } from '@babylonjs/core/Materials/PBR/pbrMaterial.js'
import { Quaternion, Vector3 } from '@babylonjs/core/Maths/math.vector.js'
import { DracoDecoder } from '@babylonjs/core/Meshes/Compression/dracoDecoder.js'
import { MeshoptCompression } from '@babylonjs/core/Meshes/Compression/meshoptCompression.js'
import type { Scene } from '@babylonjs/core/scene.js'
import '@babylonjs/loaders/glTF/2.0/Extensions/EXT_meshopt_compression.js'
import '@babylonjs/loaders/glTF/2.0/Extensions/KHR_draco_mesh_compression.js'
import '@babylonjs/loaders/glTF/2.0/Extensions/KHR_materials_specular.js'
import '@babylonjs/loaders/glTF/2.0/Extensions/KHR_mesh_quantization.js'
import '@babylonjs/loaders/glTF/2.0/Extensions/KHR_texture_transform.js'
import '@babylonjs/loaders/glTF/2.0/glTFLoader.js'
import { registerWrinkleMaps, type Wrinkles, wrinklesOf } from 'furrow/babylon'
import { type BabylonHarness, disposeScene } from '../babylon/harness.ts'
import { addressOf, type ExpectedPoint, type ExpectedPose } from './samples.ts'
import { at, type OpenedSample, PIXELS, type Pixels } from './suite.ts'

/** Frames until a pose takes effect. */
const FRAMES = 2

/** Debug modes of Babylon.js that show each quantity. */
const SHOWN = { normal: 5, roughness: 63, occlusion: 89 }

/** Path of the Draco decoder. By default Babylon.js fetches decoders from a CDN. */
const DRACO = '/node_modules/three/examples/jsm/libs/draco/gltf/'
DracoDecoder.DefaultConfiguration = {
  wasmUrl: `${DRACO}draco_wasm_wrapper.js`,
  wasmBinaryUrl: `${DRACO}draco_decoder.wasm`,
  numWorkers: 0,
}
MeshoptCompression.Configuration = { decoder: { url: '/node_modules/meshoptimizer/meshopt_decoder.cjs' } }

registerWrinkleMaps({ transcoderPath: '/node_modules/three/examples/jsm/libs/basis' })

/** Loads a sample file into a new scene. */
export async function openSample(harness: BabylonHarness, name: string): Promise<OpenedSample> {
  const scene = harness.createScene()
  const camera = scene.activeCamera as FreeCamera
  camera.position.z = 5
  camera.setTarget(Vector3.Zero())
  const container = await LoadAssetContainerAsync(addressOf(name), scene)
  container.addAllToScene()
  return new BabylonSample(harness, scene, container)
}

class BabylonSample implements OpenedSample {
  readonly #harness: BabylonHarness
  readonly #scene: Scene
  readonly #container: AssetContainer
  /** Undefined if Furrow has refused the wrinkles of the file. */
  readonly #wrinkles: Wrinkles | undefined
  #milliseconds = 0

  constructor(harness: BabylonHarness, scene: Scene, container: AssetContainer) {
    this.#harness = harness
    this.#scene = scene
    this.#container = container
    this.#wrinkles = wrinklesOf(container)[0]
    if (this.#wrinkles) this.#wrinkles.clock = { now: () => this.#milliseconds }
  }

  get isWrinkled(): boolean {
    return this.#wrinkles !== undefined
  }

  async pose({ weights = {}, inputs = {}, rotations = {}, translations = {}, seconds = 0 }: ExpectedPose) {
    for (const { morphTargetManager } of this.#container.meshes) {
      for (let i = 0; i < (morphTargetManager?.numTargets ?? 0); i++) {
        const target = morphTargetManager!.getTarget(i)
        target.influence = weights[target.name] ?? 0
      }
    }
    for (const [input, value] of Object.entries(inputs)) this.#wrinkles!.inputs.set(input, value)
    for (const node of this.#container.transformNodes) {
      node.rotationQuaternion = Quaternion.FromArray(rotations[node.name] ?? [0, 0, 0, 1])
      if (translations[node.name]) node.position = Vector3.FromArray(translations[node.name])
    }
    this.#milliseconds += 1000 * seconds
    for (let i = 0; i < FRAMES; i++) await this.#draw()
    return Object.fromEntries(
      this.#wrinkles!.areaNames.map((area) => [area, this.#wrinkles!.getActivation(area)]),
    )
  }

  async normals() {
    const shown = await this.#show('normal')
    // Babylon.js mirrors x to load right-handed files into its left-handed world.
    const component = (axis: number) =>
      shown.map((_, i) => (2 * shown[i - (i % 4) + axis] - 1) * (axis === 0 ? -1 : 1))
    return { pictures: [0, 1, 2].map(component), areColoured: false }
  }

  async colours() {
    for (const material of this.#materials) material.unlit = true
    const picture = await this.#draw()
    for (const material of this.#materials) material.unlit = false
    return { picture, areOccluded: false }
  }

  occlusion(): Promise<Pixels> {
    return this.#show('occlusion')
  }

  async hasRoughness(points: readonly ExpectedPoint[], tolerance: number): Promise<boolean> {
    const shown = await this.#show('roughness')
    return points.every(({ column, row, roughness }) => {
      return Math.abs(shown[4 * at(column, row)] - roughness) <= tolerance
    })
  }

  dispose(): Promise<void> {
    return disposeScene(this.#scene)
  }

  get #materials(): PBRMaterial[] {
    return this.#container.materials as PBRMaterial[]
  }

  async #show(shown: keyof typeof SHOWN): Promise<Pixels> {
    for (const material of this.#materials)
      Object.assign(material, { debugMode: SHOWN[shown], debugLimit: -1 })
    const picture = await this.#draw()
    for (const material of this.#materials) material.debugMode = 0
    return picture
  }

  #draw(): Promise<Pixels> {
    return this.#harness.render(this.#scene, PIXELS)
  }
}
