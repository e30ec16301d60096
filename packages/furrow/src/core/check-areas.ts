import { checkFinite, isObject, wrongArgument } from './argument.ts'
import { FurrowError } from './error.ts'
import { checkImage } from './image.ts'
import { MAX_AREAS } from './limits.ts'
import { isName, NAME_RULE } from './name.ts'
import { didYouMean } from './nearest-name.ts'
import type { Area, ArraySlice } from './types.ts'

/** Whether a map is a slice of a texture array. Otherwise, it is an image. */
export function isSlice(map: object | undefined): map is ArraySlice {
  return isObject(map) && 'slice' in map
}

/**
 * Checks the areas of influence of a wrinkle set. There must be 1 to 256 areas with unique names. Each area must be on an existing layer.
 *
 * @throws FurrowError for the first problem found.
 */
export function checkAreas(
  areas: readonly Area<ArraySlice>[],
  layers: readonly { name: string }[],
  who: string,
): void {
  checkCount(areas.length, 'areas', MAX_AREAS, who)
  for (const area of areas) checkArea(area, layers, who)
  checkNames(areas, 'area', who)
}

function checkArea(area: Area<ArraySlice>, layers: readonly { name: string }[], who: string): void {
  if (!isObject(area)) throw wrongArgument(who, 'area', area, 'an object with name and weights')
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
 * Returns the index of an area's layer. An area without a layer name is on layer 0.
 *
 * @throws FurrowError if the area names an unknown layer.
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
      problem: `area "${area.name}" is on an unknown layer`,
      value: area.layer,
      limit: listNames(layers),
      remedy: didYouMean(area.layer, namesOf(layers), 'use the name of a layer in this set'),
    })
  }
  return index
}

export function unknownArea(name: string, areas: readonly string[], who: string): FurrowError {
  return new FurrowError({
    code: 'unknown-name',
    who,
    problem: 'unknown area',
    value: name,
    limit: areas.map((area) => `"${area}"`).join(', '),
    remedy: didYouMean(name, areas, 'use the name of an area in this set, or add the area first'),
  })
}

export function listNames(named: readonly { name: string }[]): string {
  return named.map(({ name }) => `"${name}"`).join(', ')
}

function namesOf(named: readonly { name: string }[]): string[] {
  return named.map(({ name }) => name)
}

/**
 * Checks that a count is from 1 to `max`.
 *
 * @param items plural name of the counted objects, for the error.
 * @throws FurrowError if the count is out of range.
 */
export function checkCount(count: number, items: string, max: number, who: string): void {
  if (count >= 1 && count <= max) return
  throw new FurrowError({
    code: 'out-of-range',
    who,
    problem: `${count === 0 ? 'no' : 'too many'} ${items}`,
    value: count,
    limit: `1 to ${max} ${items}`,
    remedy: count === 0 ? 'add at least one' : `merge ${items} that always move together`,
  })
}

/**
 * Checks that names are valid and unique.
 *
 * @param kind singular name of the named objects, for the error.
 * @throws FurrowError if a name is invalid or used twice.
 */
export function checkNames(named: readonly { name: string }[], kind: string, who: string): void {
  const seen = new Set<string>()
  for (const { name } of named) {
    checkName(name, kind, who)
    if (seen.has(name)) {
      throw new FurrowError({
        who,
        problem: `two ${kind}s with the same name`,
        value: name,
        remedy: `give each ${kind} a different name`,
      })
    }
    seen.add(name)
  }
}

function checkName(name: unknown, kind: string, who: string): void {
  if (isName(name)) return
  throw new FurrowError({
    who,
    problem: name === undefined || name === '' ? `${kind} without a name` : `invalid ${kind} name`,
    value: name,
    limit: NAME_RULE,
    remedy: `give each ${kind} a valid name`,
  })
}
