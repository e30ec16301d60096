import { checkFinite, isObject, wrongArgument } from './argument.ts'
import { FurrowError } from './error.ts'
import { checkImage } from './image.ts'
import { MAX_AREAS } from './limits.ts'
import { isName, NAME_RULE } from './name.ts'
import { didYouMean } from './nearest-name.ts'
import type { Area, ArraySlice } from './types.ts'

/** Whether a map is a slice of an array instead of an image. */
export function isSlice(map: object | undefined): map is ArraySlice {
  return isObject(map) && 'slice' in map
}

/**
 * Checks the areas of a set: 1 to 256 with distinct names, each on a layer that exists.
 *
 * @throws FurrowError at the first fault.
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
      problem: `area "${area.name}" is on an unknown layer`,
      value: area.layer,
      limit: listNames(layers),
      remedy: didYouMean(area.layer, namesOf(layers), 'name one of the layers of the set'),
    })
  }
  return index
}

/** The error for a name that no area has. */
export function unknownArea(name: string, areas: readonly string[], who: string): FurrowError {
  return new FurrowError({
    code: 'unknown-name',
    who,
    problem: 'unknown area',
    value: name,
    limit: areas.map((area) => `"${area}"`).join(', '),
    remedy: didYouMean(name, areas, 'use the name of an area of this set, or add the area first'),
  })
}

/** The names of areas or layers, for errors. */
export function listNames(named: readonly { name: string }[]): string {
  return named.map(({ name }) => `"${name}"`).join(', ')
}

function namesOf(named: readonly { name: string }[]): string[] {
  return named.map(({ name }) => name)
}

export function checkCount(count: number, what: string, most: number, who: string): void {
  if (count >= 1 && count <= most) return
  throw new FurrowError({
    code: 'out-of-range',
    who,
    problem: `${count === 0 ? 'no' : 'too many'} ${what}`,
    value: count,
    limit: `1 to ${most} ${what}`,
    remedy: count === 0 ? 'give at least one' : 'merge those that always move together',
  })
}

export function checkNames(named: readonly { name: string }[], what: string, who: string): void {
  const seen = new Set<string>()
  for (const { name } of named) {
    checkName(name, what, who)
    if (seen.has(name)) {
      throw new FurrowError({
        who,
        problem: `two ${what}s with the same name`,
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
    problem:
      name === undefined || name === '' ? `a ${what} without a name` : `a ${what} with an unusable name`,
    value: name,
    limit: NAME_RULE,
    remedy: `give every ${what} a distinct name`,
  })
}
