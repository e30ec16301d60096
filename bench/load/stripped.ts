/**
 * The floor: the least that any library could do to show the wrinkles of the shipped face in the frame that is timed. The images of the
 * file are decoded as `GLTFLoader` decodes all others, and uploaded as ordinary textures; the activations of the one expression are
 * numbers in this file. Nothing is checked, nothing can move.
 */
import {
  DataTexture,
  LinearFilter,
  type Mesh,
  type MeshPhysicalMaterial,
  RedFormat,
  type Texture,
} from 'three'
import type { GLTF, GLTFParser } from 'three/addons/loaders/GLTFLoader.js'
import { BLOOD_ABSORPTION } from '../../packages/furrow/src/core/blood.ts'

/** What the face's material samples. */
export interface StrippedMaps {
  strippedNormals: Texture
  /** Occlusion in R, blood in B. */
  strippedSurface: Texture
  /** 0..1 in R. */
  strippedInfluence: Texture
}

/** Makes the face's material mix the maps in. */
export type StrippedPatch = (material: MeshPhysicalMaterial, maps: StrippedMaps) => void

/** Amplitude of blood in the file, times the absorption. */
export const BLOOD = BLOOD_ABSORPTION.map((absorption) => 0.35 * absorption)

/** Indices of the file's textures. */
const [NORMALS, SURFACE, ...AREAS] = [7, 8, 10, 11, 12, 13]

/** Activations of the areas in the channels of these images, as the file's drivers give them for the expression of `page.ts`. */
const ACTIVATIONS = [
  [0.5294, 0.5294, 0.6471],
  [0.6, 0.0769, 0],
  [1, 0, 0.6471],
  [0, 0, 0],
]

/** A plugin of `GLTFLoader`. */
export class StrippedPlugin {
  readonly name = 'stripped'
  readonly #parser: GLTFParser
  readonly #patch: StrippedPatch
  #textures: Promise<Texture[]> | undefined

  constructor(parser: GLTFParser, patch: StrippedPatch) {
    this.#parser = parser
    this.#patch = patch
  }

  /** Images are decoded while the rest is loaded. */
  async beforeRoot(): Promise<void> {
    const load = (index: number): Promise<Texture> => this.#parser.getDependency('texture', index)
    this.#textures = Promise.all([NORMALS, SURFACE, ...AREAS].map(load))
  }

  async afterRoot({ scene }: GLTF): Promise<void> {
    const [strippedNormals, strippedSurface, ...areas] = await this.#textures!
    const { material } = scene.getObjectByName('skin') as Mesh<never, MeshPhysicalMaterial>
    const strippedInfluence = sumAreas(areas.map(({ image }) => image as ImageBitmap))
    this.#patch(material, { strippedNormals, strippedSurface, strippedInfluence })
  }
}

/** The areas times their activations, read from one small canvas. */
function sumAreas(images: readonly ImageBitmap[]): Texture {
  const { width, height } = images[0]
  const canvas = new OffscreenCanvas(width, height * images.length)
  const context = canvas.getContext('2d', { willReadFrequently: true })!
  for (const [i, image] of images.entries()) context.drawImage(image, 0, i * height)
  const { data } = context.getImageData(0, 0, width, height * images.length)
  const sums = new Uint8Array(width * height)
  for (let i = 0; i < sums.length; i++) {
    let sum = 0
    for (let image = 0; image < images.length; image++) {
      const [red, green, blue] = ACTIVATIONS[image]
      const at = 4 * (i + image * sums.length)
      sum += red * data[at] + green * data[at + 1] + blue * data[at + 2]
    }
    sums[i] = Math.min(255, sum)
  }
  const texture = new DataTexture(sums, width, height, RedFormat)
  texture.magFilter = texture.minFilter = LinearFilter
  texture.needsUpdate = true
  return texture
}
