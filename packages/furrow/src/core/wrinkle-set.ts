import { checkFinite, isObject, wrongArgument } from './argument.ts'
import { MAX_BLOOD_AMPLITUDE } from './blood.ts'
import { checkAreas, checkCount, checkNames, isSlice } from './check-areas.ts'
import { checkImage } from './image.ts'
import { MAX_LAYERS } from './limits.ts'
import type { Area, ArraySlice, Layer } from './types.ts'

/**
 * Checks a wrinkle set. A set must have 1 to 4 layers and 1 to 256 areas with unique names and well-formed images. Each area must be on
 * an existing layer.
 *
 * @param who name of the caller in errors.
 * @throws FurrowError for the first problem found.
 */
export function checkWrinkleSet(
  set: { layers: readonly Layer<ArraySlice>[]; areas: readonly Area<ArraySlice>[] },
  who = 'WrinkleSet',
): void {
  if (!isObject(set) || !Array.isArray(set.layers) || !Array.isArray(set.areas)) {
    throw wrongArgument(who, 'wrinkle set', set, 'an object with arrays of layers and areas')
  }
  checkCount(set.layers.length, 'layers', MAX_LAYERS, who)
  for (const layer of set.layers) checkLayer(layer, who)
  checkNames(set.layers, 'layer', who)
  checkAreas(set.areas, set.layers, who)
}

function checkLayer(layer: Layer<ArraySlice>, who: string): void {
  if (!isObject(layer)) throw wrongArgument(who, 'layer', layer, 'an object with name, kind and normal')
  const { name, kind: kindOfLayer, normal, baseColor, roughness, occlusion, blood, onset, height } = layer
  if (kindOfLayer !== 'replace' && kindOfLayer !== 'detail') {
    throw wrongArgument(who, `kind of layer "${name}"`, kindOfLayer, 'replace or detail')
  }
  if (!isObject(normal)) throw wrongArgument(who, `normal of layer "${name}"`, normal, 'an image')
  checkFinite(layer.normalScale, `normalScale of layer "${name}"`, who)
  checkFinite(layer.heightAmplitude, `heightAmplitude of layer "${name}"`, who)
  if (height && layer.heightAmplitude === undefined) {
    throw wrongArgument(who, `heightAmplitude of layer "${name}"`, undefined, 'metres from black to white')
  }
  if ((layer.heightAmplitude ?? 0) < 0) {
    throw wrongArgument(who, `heightAmplitude of layer "${name}"`, layer.heightAmplitude, 'at least 0 metres')
  }
  checkFinite(layer.occlusionStrength, `occlusionStrength of layer "${name}"`, who)
  checkOnsetStrength(layer.onsetStrength, name, who)
  if (blood) checkBloodAmplitude(layer.bloodAmplitude, name, who)
  for (const [kind, map] of Object.entries({ normal, baseColor })) {
    if (map && !isSlice(map)) checkImage(map, 'RGBA', `${who} layer "${name}" ${kind}`)
  }
  for (const [kind, map] of Object.entries({ roughness, occlusion, blood, onset, height })) {
    if (map && !isSlice(map)) checkImage(map, 'gray', `${who} layer "${name}" ${kind}`)
  }
}

/** @throws FurrowError if the blood amplitude of a layer is missing or out of range. */
export function checkBloodAmplitude(amplitude: number | undefined, layer: string, who: string): void {
  if (amplitude !== undefined && amplitude >= 0 && amplitude <= MAX_BLOOD_AMPLITUDE) return
  throw wrongArgument(who, `bloodAmplitude of layer "${layer}"`, amplitude, `0 to ${MAX_BLOOD_AMPLITUDE}`)
}

/** @throws FurrowError if the onset strength of a layer is given and out of range. */
export function checkOnsetStrength(strength: number | undefined, layer: string, who: string): void {
  if (strength === undefined || (strength >= 0 && strength <= 1)) return
  throw wrongArgument(who, `onsetStrength of layer "${layer}"`, strength, '0 to 1')
}
