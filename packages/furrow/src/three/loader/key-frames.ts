import { Interpolant, InterpolateDiscrete, type KeyframeTrack, type Mesh, type TypedArray } from 'three'
import type { GLTF } from 'three/addons/loaders/GLTFLoader.js'
import { parseActivationPointer } from '../../core/activation-pointer.ts'
import { activationTrack } from '../animated-areas.ts'
import type { WrinklesBase } from '../wrinkles-base.ts'

type Parser = GLTF['parser']

/** The faces of a material by the index that it has in the file. */
export type FacesByMaterial = ReadonlyMap<number, readonly WrinklesBase[]>

/**
 * Adds to the clips of a file what animates its areas by KHR_animation_pointer.
 *
 * @throws FurrowError or whatever the loader throws where an accessor cannot be read.
 */
export async function addActivationTracks(gltf: GLTF, parser: Parser, faces: FacesByMaterial): Promise<void> {
  for (const [i, { channels, samplers }] of ((parser.json.animations ?? []) as AnimationJson[]).entries()) {
    for (const { sampler, target } of channels) {
      const pointer = parseActivationPointer(target.extensions?.KHR_animation_pointer?.pointer)
      if (target.path !== 'pointer' || !pointer) continue
      for (const wrinkles of faces.get(pointer.material) ?? []) {
        const area = wrinkles.areaNames[pointer.area]
        const clip = gltf.animations[i]
        if (area === undefined || !clip) continue
        clip.tracks.push(await readTrack(parser, samplers[sampler], wrinkles.mesh, area))
        clip.resetDuration()
      }
    }
  }
}

interface AnimationJson {
  channels: {
    sampler: number
    target: { path: string; extensions?: { KHR_animation_pointer?: { pointer: unknown } } }
  }[]
  samplers: SamplerJson[]
}

interface SamplerJson {
  input: number
  output: number
  interpolation?: 'LINEAR' | 'STEP' | 'CUBICSPLINE'
}

async function readTrack(
  parser: Parser,
  { input, output, interpolation }: SamplerJson,
  mesh: Mesh,
  area: string,
): Promise<KeyframeTrack> {
  const [times, values] = await Promise.all(
    [input, output].map(async (index) => numbersOf(await parser.getDependency('accessor', index))),
  )
  if (interpolation !== 'CUBICSPLINE') {
    const track = activationTrack(mesh, area, times, values)
    if (interpolation === 'STEP') track.setInterpolation(InterpolateDiscrete)
    return track
  }
  // The mixer is told one value for each key frame, and takes tangents and all from the interpolant.
  const track = activationTrack(
    mesh,
    area,
    times,
    Array.from(times, (_, k) => values[3 * k + 1]),
  )
  const cubic = track as KeyframeTrack & { createInterpolant(result?: Float32Array): Interpolant }
  cubic.createInterpolant = (result) =>
    new CubicSpline(Float32Array.from(times), Float32Array.from(values), 1, result)
  return track
}

/** Normalised integers as numbers 0..1. */
function numbersOf(accessor: { count: number; getX(i: number): number }): number[] {
  return Array.from({ length: accessor.count }, (_, i) => accessor.getX(i))
}

/** glTF 2.0, appendix C: each key frame holds an in-tangent, a value and an out-tangent. */
class CubicSpline extends Interpolant {
  /** Before the first key frame and after the last one. */
  override copySampleValue_(index: number): TypedArray {
    this.resultBuffer[0] = this.sampleValues[3 * index + 1]
    return this.resultBuffer
  }

  override interpolate_(next: number, t0: number, t: number, t1: number): TypedArray {
    const values = this.sampleValues
    const last = 3 * (next - 1)
    const [from, leaving] = [values[last + 1], values[last + 2] * (t1 - t0)]
    const [arriving, to] = [values[3 * next] * (t1 - t0), values[3 * next + 1]]
    const s = (t - t0) / (t1 - t0)
    this.resultBuffer[0] =
      (2 * s ** 3 - 3 * s ** 2 + 1) * from +
      (s ** 3 - 2 * s ** 2 + s) * leaving +
      (3 * s ** 2 - 2 * s ** 3) * to +
      (s ** 3 - s ** 2) * arriving
    return this.resultBuffer
  }
}
