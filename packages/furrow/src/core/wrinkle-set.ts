import { checkFinite, isObject, wrongArgument } from './argument.ts'
import { MAX_BLOOD_AMPLITUDE } from './blood.ts'
import { FurrowError } from './error.ts'
import { checkImage } from './image.ts'
import { MAX_AREAS, MAX_LAYERS } from './limits.ts'
import { isName, NAME_RULE } from './name.ts'
import type { Area, ArraySlice, Layer } from './types.ts'

/**
 * Checks a wrinkle set: 1 to 4 layers with distinct names, 1 to 256 areas with distinct names, each on a layer that exists, and
 * well-formed images.
 *
 * @param who names the caller in errors.
 * @throws FurrowError at the first fault.
 */
export function checkWrinkleSet(
  set: { layers: readonly Layer<ArraySlice>[]; areas: readonly Area<ArraySlice>[] },
  who = 'WrinkleSet',
): void {
  if (!isObject(set) || !Array.isArray(set.layers) || !Array.isArray(set.areas)) {
    throw wrongArgument(who, 'a wrinkle set', set, 'an object with a list of layers and a list of areas')
  }
  checkCount(set.layers.length, 'layers', MAX_LAYERS, who)
  checkCount(set.areas.length, 'areas', MAX_AREAS, who)
  for (const layer of set.layers) checkLayer(layer, who)
  checkNames(set.layers, 'layer', who)
  checkNames(set.areas, 'area', who)
  for (const area of set.areas) checkArea(area, set.layers, who)
}

/** Whether a map is a slice of an array instead of an image. */
export function isSlice(map: object | undefined): map is ArraySlice {
  return isObject(map) && 'slice' in map
}

function checkLayer(layer: Layer<ArraySlice>, who: string): void {
  if (!isObject(layer)) throw wrongArgument(who, 'a layer', layer, 'an object with a name, kind and normals')
  const { name, kind: kindOfLayer, normal, baseColor, roughness, occlusion, blood, height } = layer
  if (kindOfLayer !== 'replace' && kindOfLayer !== 'detail') {
    throw wrongArgument(who, `kind of layer "${name}"`, kindOfLayer, 'replace or detail')
  }
  if (!isObject(normal)) throw wrongArgument(who, `normals of layer "${name}"`, normal, 'an image')
  checkFinite(layer.normalScale, `normalScale of layer "${name}"`, who)
  checkFinite(layer.heightAmplitude, `heightAmplitude of layer "${name}"`, who)
  if (height && layer.heightAmplitude === undefined) {
    throw wrongArgument(
      who,
      `heights of layer "${name}" without heightAmplitude`,
      undefined,
      'metres from black to white',
    )
  }
  if ((layer.heightAmplitude ?? 0) < 0) {
    throw wrongArgument(who, `heightAmplitude of layer "${name}"`, layer.heightAmplitude, '0 metres or more')
  }
  checkFinite(layer.occlusionStrength, `occlusionStrength of layer "${name}"`, who)
  if (blood) checkBloodAmplitude(layer.bloodAmplitude, name, who)
  for (const [kind, map] of Object.entries({ normal, baseColor })) {
    if (map && !isSlice(map)) checkImage(map, 'RGBA', `${who} layer "${name}" ${kind}`)
  }
  for (const [kind, map] of Object.entries({ roughness, occlusion, blood, height })) {
    if (map && !isSlice(map)) checkImage(map, 'gray', `${who} layer "${name}" ${kind}`)
  }
}

/** @throws FurrowError when the amplitude of a layer's blood is missing or out of range. */
export function checkBloodAmplitude(amplitude: number | undefined, layer: string, who: string): void {
  if (amplitude !== undefined && amplitude >= 0 && amplitude <= MAX_BLOOD_AMPLITUDE) return
  throw wrongArgument(who, `bloodAmplitude of layer "${layer}"`, amplitude, `0 to ${MAX_BLOOD_AMPLITUDE}`)
}

/**
 * Checks one area against the layers it may belong to.
 *
 * @throws FurrowError when its name or its image is malformed, or its layer unknown.
 */
export function checkArea(
  area: Area<ArraySlice>,
  layers: readonly { name: string }[],
  who = 'WrinkleSet',
): void {
  if (!isObject(area)) throw wrongArgument(who, 'an area', area, 'an object with a name and weights')
  checkName(area.name, 'area', who)
  if (!isObject(area.weights)) {
    throw wrongArgument(who, `weights of area "${area.name}"`, area.weights, 'a gray image')
  }
  if (area.combine !== undefined && area.combine !== 'sum' && area.combine !== 'max') {
    throw wrongArgument(who, `combine of area "${area.name}"`, area.combine, 'sum or max')
  }
  checkFinite(area.activation, `activation of area "${area.name}"`, who)
  if (!isSlice(area.weights)) checkImage(area.weights, 'gray', `${who} area "${area.name}"`)
  layerIndex(area, layers, who)
}

/**
 * Index of the layer that an area is on: the first if it names none.
 *
 * @throws FurrowError when it names an unknown one.
 */
export function layerIndex(
  area: { name: string; layer?: string },
  layers: readonly { name: string }[],
  who = 'WrinkleSet',
): number {
  if (area.layer === undefined) return 0
  const index = layers.findIndex((layer) => layer.name === area.layer)
  if (index < 0) {
    throw new FurrowError({
      code: 'unknown-name',
      who,
      what: `area "${area.name}" is on an unknown layer`,
      value: area.layer,
      limit: listNames(layers),
      remedy: 'name one of the layers of the set',
    })
  }
  return index
}

/** The names of areas or layers, for errors. */
export function listNames(named: readonly { name: string }[]): string {
  return named.map(({ name }) => `"${name}"`).join(', ')
}

function checkCount(count: number, what: string, most: number, who: string): void {
  if (count >= 1 && count <= most) return
  throw new FurrowError({
    code: 'out-of-range',
    who,
    what: `${count === 0 ? 'no' : 'too many'} ${what}`,
    value: count,
    limit: `1 to ${most} ${what}`,
    remedy: count === 0 ? 'give at least one' : 'merge those that always move together',
  })
}

function checkNames(named: readonly { name: string }[], what: string, who: string): void {
  const seen = new Set<string>()
  for (const { name } of named) {
    checkName(name, what, who)
    if (seen.has(name)) {
      throw new FurrowError({
        who,
        what: `two ${what}s with the same name`,
        value: name,
        remedy: `give every ${what} a distinct name`,
      })
    }
    seen.add(name)
  }
}

function checkName(name: unknown, what: string, who: string): void {
  if (isName(name)) return
  throw new FurrowError({
    who,
    what: name === undefined || name === '' ? `a ${what} without a name` : `a ${what} with an unusable name`,
    value: name,
    limit: NAME_RULE,
    remedy: `give every ${what} a distinct name`,
  })
}
