import type { GrayImage } from 'furrow'
import { explain, reference } from 'furrow/internal'
import { type Pixels, pixelsOf, targetNamesOf, weightsOf } from 'furrow-files'
import { readWrinkledFile } from 'furrow-files/node'
import { centreOf } from './paint.ts'

/** State of a face: blendshape weights and inputs by name. */
export type Pose = Readonly<Record<string, number>>

/** Evaluates the shading of a file with wrinkles in float64, at the texel centres of its maps. */
export class Evaluated {
  readonly #load: Awaited<ReturnType<typeof load>>

  static async of(path: string): Promise<Evaluated> {
    return new Evaluated(await load(path))
  }

  private constructor(loaded: Awaited<ReturnType<typeof load>>) {
    this.#load = loaded
  }

  get size(): number {
    return this.#load.layers[0]!.normal.width
  }

  /** Returns the activation of each area by name. */
  activations(pose: Pose): Map<string, number> {
    const { file, targetNames } = this.#load
    const weights = targetNames.map((name) => pose[name] ?? 0)
    const found = explain(file.maps.drivers, file.maps.areas, { targetNames, weights, inputs: pose })
    return new Map(found.map(({ area, activation }) => [area, activation]))
  }

  /**
   * Returns the normals and base colours (linear) that a pose shows, three numbers per texel.
   *
   * @param texels texels to shade; all others are 0. Default: all.
   */
  shade(pose: Pose, texels?: readonly number[]): { normals: Float64Array; colours: Float64Array } {
    const { file, layers, areas, base, baseColour } = this.#load
    const activations = this.activations(pose)
    const active = file.maps.areas.map(({ name, layer, combine }) => ({
      activation: activations.get(name)!,
      layer,
      combine,
    }))
    const { size } = this
    const normals = new Float64Array(3 * size * size)
    const colours = new Float64Array(3 * size * size)
    for (const i of texels ?? Array(size * size).keys()) {
      const [u, v] = centreOf(i, size)
      const influences = layers.map(({ onset, onsetStrength }, layer) => {
        const influence = reference.influenceFromMap(areas, active, u, v, layer)
        return onset ? reference.onsetInfluence(influence, onset[i]! / 255, onsetStrength) : influence
      })
      const own = [0, 1, 2].map((k) => base.data[base.channels * i + k]! / 127.5 - 1)
      const mixed = reference.mixNormals(
        own,
        layers.map(({ kind, normal }, k) => ({
          kind,
          normal: [0, 1, 2].map((c) => normal.data[normal.channels * i + c]! / 127.5 - 1),
          influence: influences[k]!,
        })),
      )
      normals.set(mixed, 3 * i)
      if (!baseColour) continue
      const coloured = layers.flatMap(({ colour }, k) =>
        colour ? [{ value: linearAt(colour, i), influence: influences[k]! }] : [],
      )
      colours.set(reference.mixValues(linearAt(baseColour, i), coloured), 3 * i)
    }
    return { normals, colours }
  }
}

async function load(path: string) {
  const who = 'test'
  const file = await readWrinkledFile(path, who)
  const { glb, maps } = file
  const mesh = glb.json.meshes!.find(({ primitives }) =>
    primitives.some((primitive) => primitive.material === file.material),
  )!
  const read = (info: { index: number } | undefined) => info && pixelsOf(glb, info, who)
  const layers = await Promise.all(
    maps.layers.map(async (layer) => ({
      kind: layer.kind,
      normal: (await read(layer.normalTexture))!,
      colour: await read(layer.baseColorTexture),
      onset: greenOf(await read(layer.onsetTexture)),
      onsetStrength: layer.onsetTexture?.strength ?? 1,
    })),
  )
  const weights = await Promise.all(maps.areas.map((_, i) => weightsOf(file, i, who)))
  const material = glb.json.materials![file.material]!
  const baseColour = await read(material.pbrMetallicRoughness?.baseColorTexture)
  return {
    file,
    targetNames: targetNamesOf(mesh),
    layers,
    areas: arrayOf(weights),
    base: (await read(material.normalTexture))!,
    baseColour: baseColour?.width === layers[0]!.normal.width ? baseColour : undefined,
  }
}

function greenOf(pixels: Pixels | undefined): Uint8Array | undefined {
  return (
    pixels &&
    Uint8Array.from({ length: pixels.width * pixels.height }, (_, i) => {
      return pixels.data[pixels.channels * i + Math.min(1, pixels.channels - 1)]!
    })
  )
}

function arrayOf(weights: readonly GrayImage[]) {
  const [{ width, height }] = weights as [GrayImage]
  const data = new Uint8Array(width * height * weights.length)
  for (const [i, one] of weights.entries()) data.set(one.data, i * width * height)
  return { width, height, depth: weights.length, channels: 1 as const, data }
}

export function linearAt({ channels, data }: Pixels, texel: number): number[] {
  return [0, 1, 2].map((k) => toLinear(data[channels * texel + k]! / 255))
}

export function toLinear(value: number): number {
  return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4
}

export function toSrgb(value: number): number {
  return value <= 0.0031308 ? 12.92 * value : 1.055 * value ** (1 / 2.4) - 0.055
}

/** Returns `count` texels of a square map of `size`, spread evenly. */
export function someTexels(size: number, count: number): number[] {
  return Array.from({ length: count }, (_, i) => Math.floor(((i + 0.5) * size * size) / count))
}

/** Returns the largest difference between normals in steps of 1/255, as a normal map stores them. */
export function normalSteps(a: ArrayLike<number>, b: ArrayLike<number>): number {
  return largest(a, b, (x, y) => 127.5 * Math.abs(x - y))
}

/** Returns the largest difference between linear colours in steps of 1/255 of sRGB. */
export function colourSteps(a: ArrayLike<number>, b: ArrayLike<number>): number {
  return largest(a, b, (x, y) => 255 * Math.abs(toSrgb(x) - toSrgb(y)))
}

/** Skips texels of `a` that are 0, because they were not shaded. */
function largest(
  a: ArrayLike<number>,
  b: ArrayLike<number>,
  distance: (x: number, y: number) => number,
): number {
  let most = 0
  for (let i = 0; i < a.length; i++) if (a[i] !== 0) most = Math.max(most, distance(a[i]!, b[i]!))
  return most
}
