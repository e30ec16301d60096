import { Interpolant, InterpolateDiscrete, type KeyframeTrack, type Mesh, type TypedArray } from 'three'
import type { GLTF } from 'three/addons/loaders/GLTFLoader.js'
import { type ActivationPointer, parseActivationPointer } from '../../core/activation-pointer.ts'
import { FurrowError } from '../../core/error.ts'
import { WRINKLE_MAPS } from '../../core/maps/declared.ts'
import type { Warnings } from '../../runtime/file/warnings.ts'
import { activationTrack } from '../activation-track.ts'
import type { WrinklesBase } from '../wrinkles-base.ts'

type Parser = GLTF['parser']

export interface LoadedFace {
  /** Material index in the file. */
  material: number
  wrinkles: WrinklesBase
}

/** Maximum number of key frames per area. */
const MAX_KEY_FRAMES = 1_000_000

/** Removes animation channels that animate areas of wrinkles, but have no valid sampler. `GLTFLoader` would otherwise reject the file. */
export function dropInvalidChannels(parser: Parser, warnings: Warnings): void {
  for (const animation of parser.json.animations as Partial<AnimationJson>[]) {
    if (!Array.isArray(animation?.channels)) continue
    animation.channels = animation.channels.filter((channel) => {
      if (!pointerOf(channel) || animation.samplers?.[channel.sampler]) return true
      warnings.add(invalid('missing sampler', channel.sampler), REMEDY)
      return false
    })
  }
}

/** Adds a track to the clips of a file for each area that KHR_animation_pointer animates. Skips invalid tracks with a warning. */
export async function addActivationTracks(
  gltf: GLTF,
  parser: Parser,
  faces: readonly LoadedFace[],
  warnings: Warnings,
): Promise<void> {
  for (const [i, { channels, samplers }] of (parser.json.animations as AnimationJson[]).entries()) {
    for (const channel of channels) {
      const pointer = pointerOf(channel)
      if (!pointer) continue
      for (const { material, wrinkles } of faces) {
        if (material !== pointer.material) continue
        const area = wrinkles.areaNames[pointer.area]
        const clip = gltf.animations[i]
        if (area === undefined || !clip) continue
        try {
          clip.tracks.push(await readTrack(parser, samplers[channel.sampler], wrinkles.mesh, area))
          clip.resetDuration()
        } catch (error) {
          const reported = error instanceof FurrowError ? error : invalid('unreadable accessors', area)
          warnings.add(reported, REMEDY)
        }
      }
    }
  }
}

const REMEDY = 'the other tracks of the animation keep playing'

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

function pointerOf(channel: AnimationJson['channels'][number] | null): ActivationPointer | undefined {
  if (channel?.target?.path !== 'pointer') return undefined
  return parseActivationPointer(channel.target.extensions?.KHR_animation_pointer?.pointer)
}

function invalid(problem: string, value: unknown): FurrowError {
  return new FurrowError({
    who: WRINKLE_MAPS,
    problem: `invalid animation of an area: ${problem}`,
    value,
    limit: `increasing times from 0, one activation each, at most ${MAX_KEY_FRAMES} key frames`,
    remedy: 'export the animation again',
  })
}

async function readTrack(
  parser: Parser,
  { input, output, interpolation }: SamplerJson,
  mesh: Mesh,
  area: string,
): Promise<KeyframeTrack> {
  const counts = [input, output].map((index) => parser.json.accessors?.[index]?.count)
  // The counts are checked before decoding, because an accessor without a buffer view can declare any number of elements.
  if (counts.some((count) => !(count >= 1 && count <= 3 * MAX_KEY_FRAMES))) {
    throw invalid('accessor counts', counts.join(' and '))
  }
  const [times, values] = await Promise.all(
    [input, output].map(async (index) => numbersOf(await parser.getDependency('accessor', index))),
  )
  checkKeyFrames(times, values, interpolation === 'CUBICSPLINE' ? 3 : 1)
  if (interpolation !== 'CUBICSPLINE') {
    const track = activationTrack(mesh, area, times, values)
    if (interpolation === 'STEP') track.setInterpolation(InterpolateDiscrete)
    return track
  }
  // The track stores one value per key frame. Tangents are in the interpolant, which replaces the interpolant of three.js.
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

function checkKeyFrames(times: readonly number[], values: readonly number[], valuesPerKey: number): void {
  if (values.length !== valuesPerKey * times.length) {
    throw invalid('times and activations of different lengths', `${times.length} and ${values.length}`)
  }
  const unordered = times.findIndex((time, i) => !(time >= 0 && (i === 0 || time > times[i - 1])))
  if (unordered >= 0) throw invalid('times do not increase', times[unordered])
  const bad = values.find((value) => !Number.isFinite(value))
  if (bad !== undefined) throw invalid('activations are not finite', bad)
}

/** Reads a scalar accessor; normalised integers become 0..1. */
function numbersOf(accessor: { count: number; getX(i: number): number }): number[] {
  return Array.from({ length: accessor.count }, (_, i) => accessor.getX(i))
}

/** Cubic spline interpolation of glTF 2.0, appendix C. The samples of each key frame are an in-tangent, a value and an out-tangent. */
class CubicSpline extends Interpolant {
  /** Called by three.js for times before the first key frame and after the last. */
  override copySampleValue_(index: number): TypedArray {
    this.resultBuffer[0] = this.sampleValues[3 * index + 1]
    return this.resultBuffer
  }

  override interpolate_(next: number, t0: number, t: number, t1: number): TypedArray {
    const values = this.sampleValues
    const last = 3 * (next - 1)
    const [from, outTangent] = [values[last + 1], values[last + 2] * (t1 - t0)]
    const [inTangent, to] = [values[3 * next] * (t1 - t0), values[3 * next + 1]]
    const s = (t - t0) / (t1 - t0)
    this.resultBuffer[0] =
      (2 * s ** 3 - 3 * s ** 2 + 1) * from +
      (s ** 3 - 2 * s ** 2 + s) * outTangent +
      (3 * s ** 2 - 2 * s ** 3) * to +
      (s ** 3 - s ** 2) * inTangent
    return this.resultBuffer
  }
}
