import type { Area, ArraySlice } from '../core/types.ts'
import type { InputOf } from '../drivers/activation.ts'
import { measuredSource } from '../drivers/sources.ts'
import { TensionMeasurement } from '../drivers/tension/measure.ts'
import { coverage, type SampledMesh, sampleCovered } from '../drivers/tension/samples.ts'
import type { InputReader } from './driver-runtime.ts'

/** Number of sampled triangles per area. */
const SAMPLES = 16

/** Surface on which tension is measured. Tension is the stretch or compression of an area's skin relative to the rest pose. */
export interface TensionSurface {
  /** Mesh in the rest pose. */
  sampled: SampledMesh
  /** Area and direction of each driver input that reads tension, without duplicates. */
  measured: readonly MeasuredArea[]
}

export interface MeasuredArea {
  area: string
  direction?: InputOf<'tension'>['direction']
  /** For each triangle, how much the area covers it; see `coverage`. Empty if unknown. */
  covered: Float64Array
}

/**
 * Collects the areas whose tension is measured, and computes how much each of these areas covers each triangle. For areas in compressed
 * textures, `covered` is empty.
 *
 * @param areaOf returns the area called `name`, or undefined if it does not exist.
 */
export function tensionSurface(
  sampled: SampledMesh,
  inputs: readonly InputOf<'tension'>[],
  areaOf: (name: string) => Area<ArraySlice> | undefined,
): TensionSurface {
  const covered = new Map<string, Float64Array>()
  for (const { area } of inputs) {
    if (covered.has(area)) continue
    const weights = areaOf(area)?.weights
    covered.set(area, weights && 'data' in weights ? coverage(sampled, weights) : new Float64Array())
  }
  const measured = inputs.filter((input, i) => indexIn(inputs, input) === i)
  return {
    sampled,
    measured: measured.map(({ area, direction }) => ({ area, direction, covered: covered.get(area)! })),
  }
}

/** Returns the index of the item in `measured` that has the area and direction of an input. */
export function indexIn(measured: readonly Measured[], { area, direction }: Measured): number {
  return measured.findIndex((own) => own.area === area && own.direction?.join() === direction?.join())
}

type Measured = Pick<MeasuredArea, 'area' | 'direction'>

/**
 * Creates a reader that measures tension on the CPU, on `SAMPLES` triangles of each area.
 *
 * @param read writes the deformed position of a vertex to three items of `positions`, starting at index `offset`.
 */
export function sampledTension(
  { sampled, measured }: TensionSurface,
  inputs: readonly InputOf<'tension'>[],
  read: (vertex: number, positions: Float64Array, offset: number) => void,
): InputReader<unknown> {
  const areas = [...new Map(measured.map((own) => [own.area, own.covered]))]
  const samples = areas.map(([, covered]) => sampleCovered(sampled, covered, SAMPLES))
  const vertices = Uint32Array.from(new Set(samples.flatMap((triangles) => [...triangles])))
  const indices = new Map([...vertices].map((vertex, i) => [vertex, i]))
  const ofVertices = (array: ArrayLike<number>, size: number) =>
    Float64Array.from(
      [...vertices].flatMap((vertex) => Array.from({ length: size }, (_, k) => array[size * vertex + k])),
    )
  const rest = ofVertices(sampled.positions, 3)
  const bound = areas.map(([area], i) => ({
    area,
    triangles: samples[i].map((vertex) => indices.get(vertex)!),
  }))
  const measurement = new TensionMeasurement(inputs, bound, rest, ofVertices(sampled.uvs, 2))
  const positions = new Float64Array(rest.length)
  return {
    ...measuredSource(measurement.missing),
    read(values) {
      for (let i = 0; i < vertices.length; i++) read(vertices[i], positions, 3 * i)
      measurement.measure(positions, values)
    },
  }
}
