import type { Area, GrayImage, Layer } from 'furrow'
import { packGrays, reference } from 'furrow/internal'
import { influenceAt } from './influence-at.ts'
import { MAP } from './layer-values.ts'

/**
 * Computes, in float64, how blood maps change the picture of a square.
 *
 * @param plain picture without blood maps, with one pixel per texel of the maps.
 * @param layers layers whose maps have `MAP` texels per side.
 */
export function absorbed(
  plain: Float32Array,
  layers: readonly Layer[],
  areas: readonly Area[],
  activations: readonly number[],
): Float32Array {
  const names = layers.map(({ name }) => name)
  const influence = influenceAt(areas, activations, MAP, names)
  const packed = (map: GrayImage | undefined) => map && packGrays([map])
  const maps = layers.map(({ blood }) => packed(blood))
  const onsets = layers.map(({ onset }) => packed(onset))
  const exact = plain.slice()
  for (let pixel = 0; pixel < MAP * MAP; pixel++) {
    const u = ((pixel % MAP) + 0.5) / MAP
    const v = 1 - (Math.floor(pixel / MAP) + 0.5) / MAP
    const values = layers.flatMap(({ bloodAmplitude, onsetStrength }, i) => {
      const [map, onset] = [maps[i], onsets[i]]
      if (!map) return []
      const value = [reference.bloodOf(reference.sampleArray(map, u, v, 0)) * bloodAmplitude!]
      const own = influence(u, v, i)
      if (!onset) return [{ value, influence: own }]
      const delay = reference.sampleArray(onset, u, v, 0)
      return [{ value, influence: reference.onsetInfluence(own, delay, onsetStrength) }]
    })
    const [blood] = reference.mixValues([0], values)
    exact.set(reference.bloodColour([...plain.subarray(4 * pixel, 4 * pixel + 3)], blood), 4 * pixel)
  }
  return exact
}
