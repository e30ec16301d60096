import type { ExpectedPoint, ExpectedPose } from '../gpu/conformance/samples.ts'
import { at, type OpenedSample, PIXELS, type Pixels } from '../gpu/conformance/suite.ts'
import type { GodotHarness, GodotScene, Json, Picture } from './harness.ts'

const AXES = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
]

/** Energy of lights for colours brighter than white. The mean of several pictures has smaller rounding errors. */
const DIM = [0.5, 0.58, 0.66]

/** Loads a sample file into a new scene of Godot. */
export async function openSample(harness: GodotHarness, bytes: ArrayBuffer): Promise<OpenedSample> {
  const scene = await harness.open(bytes)
  if ('error' in scene) throw new Error(`Godot cannot load the sample: ${scene.error}`)
  return new GodotSample(scene)
}

class GodotSample implements OpenedSample {
  readonly #scene: GodotScene

  constructor(scene: GodotScene) {
    this.#scene = scene
  }

  get isWrinkled(): boolean {
    return this.#scene.faces > 0
  }

  async pose({ weights, inputs, rotations, translations, seconds }: ExpectedPose) {
    const [activations] = await this.#scene.call<Record<string, number>[]>('pose', {
      weights,
      inputs,
      rotations,
      translations,
      seconds,
    })
    return activations
  }

  async normals() {
    const pictures: Pixels[] = []
    for (const from of AXES) pictures.push(await this.#draw({ from }))
    return { pictures, areColoured: true }
  }

  async colours() {
    return { picture: await this.#draw({}), areOccluded: true }
  }

  async hasRoughness(points: readonly ExpectedPoint[], tolerance: number): Promise<boolean> {
    const shown = await this.#scene.draw('draw_roughness')
    return points.every(({ column, row, roughness }) => {
      return Math.abs(shown[4 * (column + row * PIXELS)] / 255 - roughness) <= tolerance
    })
  }

  /** Draws linear colours. Pixels that are too bright are taken from pictures in less light. */
  async #draw(args: Json): Promise<Pixels> {
    const shown = linear(await this.#scene.draw('draw', args))
    if (!shown.some((value, i) => value >= 1 && i % 4 < 3)) return shown
    const dim: Pixels[] = []
    for (const energy of DIM) dim.push(linear(await this.#scene.draw('draw', { ...args, energy })))
    const mean = (i: number) => DIM.reduce((sum, energy, k) => sum + dim[k][i] / energy, 0) / DIM.length
    return shown.map((value, i) => (value < 1 ? value : mean(i)))
  }

  dispose(): Promise<void> {
    return this.#scene.close()
  }
}

/** Converts a picture to linear colours (IEC 61966-2-1), with rows from the bottom. */
function linear(picture: Picture): Pixels {
  const pixels = new Float32Array(picture.length)
  for (let row = 0; row < PIXELS; row++) {
    for (let column = 0; column < PIXELS; column++) {
      for (let channel = 0; channel < 4; channel++) {
        const value = picture[4 * (column + row * PIXELS) + channel] / 255
        pixels[4 * at(column, row) + channel] =
          value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4
      }
    }
  }
  return pixels
}
