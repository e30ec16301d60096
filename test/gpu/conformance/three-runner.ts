import { type Wrinkles, wrinklesOf } from 'furrow/three'
import {
  AmbientLight,
  type BufferGeometry,
  DirectionalLight,
  type Mesh,
  type MeshPhysicalMaterial,
  type Object3D,
  Scene,
} from 'three'
import { MeshoptDecoder } from 'three/addons/libs/meshopt_decoder.module.js'
import { DRACOLoader } from 'three/addons/loaders/DRACOLoader.js'
import { type GLTF, GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'
import { KTX2Loader } from 'three/addons/loaders/KTX2Loader.js'
import { type Harness, squareCamera } from '../harness.ts'
import { addressOf, type ExpectedPoint, type ExpectedPose } from './samples.ts'
import { at, type OpenedSample, PIXELS, type Pixels } from './suite.ts'

type Square = Mesh<BufferGeometry, MeshPhysicalMaterial>

/** Frames until a pose takes effect. */
const FRAMES = 4

/** Reads and draws sample files with three.js. */
export class ThreeRunner {
  readonly #harness: Harness
  readonly #loader: GLTFLoader
  readonly #ktx2 = new KTX2Loader().setTranscoderPath('/node_modules/three/examples/jsm/libs/basis/')
  readonly #draco = new DRACOLoader().setDecoderPath('/node_modules/three/examples/jsm/libs/draco/gltf/')

  constructor(harness: Harness) {
    this.#harness = harness
    this.#ktx2.detectSupport(harness.renderer as never)
    this.#loader = new GLTFLoader()
      .setKTX2Loader(this.#ktx2)
      .setDRACOLoader(this.#draco)
      .setMeshoptDecoder(MeshoptDecoder)
      .register((parser) => new harness.Plugin(parser))
  }

  async open(name: string): Promise<OpenedSample> {
    return new ThreeSample(this.#harness, await this.#loader.loadAsync(addressOf(name)))
  }

  dispose(): void {
    this.#ktx2.dispose()
    this.#draco.dispose()
  }
}

/** Loaded sample file. */
class ThreeSample implements OpenedSample {
  readonly #harness: Harness
  readonly #root: Object3D
  readonly #meshes: Square[] = []
  /** Undefined if Furrow has refused the wrinkles of the file. */
  readonly #wrinkles: Wrinkles | undefined
  #milliseconds = 0

  constructor(harness: Harness, { scene }: GLTF) {
    this.#harness = harness
    this.#root = scene
    scene.traverse((object) => {
      if ('isMesh' in object) this.#meshes.push(object as Square)
    })
    this.#wrinkles = wrinklesOf(this.#meshes[0])
    if (this.#wrinkles) this.#wrinkles.clock = { now: () => this.#milliseconds }
  }

  get isWrinkled(): boolean {
    return this.#wrinkles !== undefined
  }

  async pose({ weights = {}, inputs = {}, rotations = {}, translations = {}, seconds = 0 }: ExpectedPose) {
    for (const { morphTargetDictionary = {}, morphTargetInfluences } of this.#meshes) {
      for (const [target, index] of Object.entries(morphTargetDictionary)) {
        morphTargetInfluences![index] = weights[target] ?? 0
      }
    }
    for (const [input, value] of Object.entries(inputs)) this.#wrinkles!.inputs.set(input, value)
    this.#root.traverse((node) => {
      node.quaternion.fromArray(rotations[node.name] ?? [0, 0, 0, 1])
      if (translations[node.name]) node.position.fromArray(translations[node.name])
    })
    this.#root.updateMatrixWorld()
    this.#milliseconds += 1000 * seconds
    // On WebGPU the GPU measures tension, which takes some frames.
    for (let i = 0; i < FRAMES; i++) await this.#draw(new AmbientLight())
    return Object.fromEntries(
      this.#wrinkles!.areaNames.map((area) => [area, this.#wrinkles!.getActivation(area)]),
    )
  }

  /** Renders one picture per axis. A light along the axis makes the picture show this component of the normals. */
  async normals() {
    const pictures: Pixels[] = []
    for (const axis of [0, 1, 2]) {
      const light = new DirectionalLight(0xffffff, Math.PI)
      light.position.set(0, 0, 0).setComponent(axis, 1)
      pictures.push(await this.#draw(light))
    }
    return { pictures, areColoured: true }
  }

  async colours() {
    return { picture: await this.#draw(new AmbientLight(0xffffff, Math.PI)), areOccluded: true }
  }

  /** Compares the highlights with those of the material without wrinkles at the expected roughness. */
  async hasRoughness(points: readonly ExpectedPoint[], tolerance: number): Promise<boolean> {
    if (points.every(({ roughness }) => roughness === 1)) return true
    const shown = await this.#highlights()
    for (const { column, row, roughness } of points) {
      const plain = await this.#highlights(roughness)
      if (Math.abs(shown[4 * at(column, row)] - plain[4 * at(column, row)]) > tolerance) return false
    }
    return true
  }

  dispose(): void {
    this.#wrinkles?.dispose()
    for (const { geometry, material } of this.#meshes) {
      geometry.dispose()
      material.dispose()
    }
  }

  /** Renders highlights with wrinkles, or without wrinkles at a given roughness. */
  async #highlights(plainRoughness?: number): Promise<Pixels> {
    const light = new DirectionalLight(0xffffff, Math.PI).translateZ(1)
    const [{ material }] = this.#meshes
    const { specularIntensity, roughness } = material
    Object.assign(material, { specularIntensity: 1, roughness: plainRoughness ?? roughness })
    this.#wrinkles!.mode = plainRoughness === undefined ? 'default' : 'off'
    const picture = await this.#draw(light)
    this.#wrinkles!.mode = 'default'
    Object.assign(material, { specularIntensity, roughness })
    return picture
  }

  #draw(light: AmbientLight | DirectionalLight): Promise<Pixels> {
    return this.#harness.render(new Scene().add(this.#root, light), squareCamera(), PIXELS)
  }
}
