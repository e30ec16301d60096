import { FurrowError } from './error.ts'
import { checkImage } from './image.ts'
import { MAX_AREAS, MAX_LAYERS } from './limits.ts'
import type { Area, ArraySlice, Layer } from './types.ts'

/**
 * Checks a whole wrinkle set.
 *
 * @throws FurrowError at the first fault: 1 to 4 layers of one size with distinct names, 1 to 256 areas with
 *   distinct names, every area on a layer that exists.
 */
export function checkWrinkleSet(
  set: { layers: readonly Layer<ArraySlice>[]; areas: readonly Area<ArraySlice>[] },
  who = 'WrinkleSet',
): void {
  checkCount(set.layers.length, 'layers', MAX_LAYERS, who)
  checkCount(set.areas.length, 'areas', MAX_AREAS, who)
  for (const layer of set.layers) checkLayer(layer, who)
  checkNames(set.layers, 'layer', who)
  checkNames(set.areas, 'area', who)
  for (const area of set.areas) checkArea(area, set.layers, who)
}

/** Whether a map is a slice of an array and not an image. */
export function isSlice(map: object | undefined): map is ArraySlice {
  return map !== undefined && 'slice' in map
}

function checkLayer({ name, normal, baseColor, roughness, occlusion }: Layer<ArraySlice>, who: string): void {
  for (const [kind, map] of Object.entries({ normal, baseColor })) {
    if (map && !isSlice(map)) checkImage(map, 'RGBA', `${who} layer "${name}" ${kind}`)
  }
  for (const [kind, map] of Object.entries({ roughness, occlusion })) {
    if (map && !isSlice(map)) checkImage(map, 'gray', `${who} layer "${name}" ${kind}`)
  }
}

/**
 * Checks one area against the layers it may belong to.
 *
 * @throws FurrowError when its image is malformed or its layer unknown.
 */
export function checkArea(
  area: Area<ArraySlice>,
  layers: readonly { name: string }[],
  who = 'WrinkleSet',
): void {
  if (!isSlice(area.weights)) checkImage(area.weights, 'gray', `${who} area "${area.name}"`)
  layerIndex(area, layers, who)
}

/** Index of the layer an area shows: the first when it names none. */
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

/** The names of areas or layers as a list that an error can show. */
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
    remedy:
      count === 0 ? `give at least one of its ${what}` : 'merge those that never move apart from each other',
  })
}

function checkNames(named: readonly { name: string }[], what: string, who: string): void {
  const seen = new Set<string>()
  for (const { name } of named) {
    if (typeof name !== 'string' || name === '' || seen.has(name)) {
      throw new FurrowError({
        who,
        what: seen.has(name) ? `two ${what}s of one name` : `a ${what} without a name`,
        value: name,
        remedy: `give every ${what} a name of its own`,
      })
    }
    seen.add(name)
  }
}
