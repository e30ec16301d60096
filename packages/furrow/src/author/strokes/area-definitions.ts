import type { JsonReader, Uv } from '../../core/json.ts'
import { fileNamesOf, isFileName } from '../file-names.ts'

/** Shape with a soft edge: the inside of a polygon, or the skin around the strokes (wrinkles) of a group. */
export type AreaShape = PolygonShape | GroupShape

/** Inside of a polygon in UV space, with a soft edge. */
export interface PolygonShape {
  /** At least 3 points [u, v], 0..1; the last is joined to the first. */
  polygon: Uv[]
  /** Width of the soft edge in millimetres, 0.1..200. Across the edge the weight falls from 1 to 0; it is 0.5 on the outline. */
  feather: number
}

/** Skin around the strokes of a group, with a soft edge. */
export interface GroupShape {
  /** Name of a group of strokes in the same document. */
  group: string
  /** Distance from the strokes in millimetres, 0..100, at which the weight is 0.5. */
  radius: number
  /** Width of the soft edge in millimetres, 0.1..200. */
  feather: number
}

/**
 * Definition of an area of influence: a map of weights, 0..1, that tells where a group of wrinkles appears. The weight at a texel is the
 * maximum weight of all `shapes`, multiplied by the weight of `within` if given.
 */
export interface AreaDefinition {
  name: string
  shapes: AreaShape[]
  /** Shape that the area is restricted to, for example a polygon around the left half of the face. */
  within?: AreaShape
}

/**
 * Reads and checks the field `areas` of a strokes document.
 *
 * @param groups names of the groups of strokes in the document.
 * @throws FurrowError if a definition is invalid.
 */
export function readAreaDefinitions(
  read: JsonReader,
  definitions: unknown[],
  groups: ReadonlySet<string | undefined>,
): AreaDefinition[] {
  const names = new Set<string>()
  return definitions.map((json, i) => {
    const path = `areas[${i}]`
    const field = read.object(json, path, ['name', 'shapes', 'within'])
    const name = read.name(field.name, `${path}.name`)
    checkFileName(read, name, `${path}.name`)
    if (names.has(name))
      read.fail(`${path}.name is already used`, name, undefined, 'give every area its own name')
    names.add(name)
    const shapes = read
      .array(field.shapes, `${path}.shapes`, 1, 100)
      .map((shape, k) => readShape(read, shape, `${path}.shapes[${k}]`, groups))
    const definition: AreaDefinition = { name, shapes }
    if (field.within !== undefined) {
      definition.within = readShape(read, field.within, `${path}.within`, groups)
    }
    return definition
  })
}

/** Fails if the name cannot be a file name on every system, because each area is stored as an image file with its name. */
function checkFileName(read: JsonReader, name: string, path: string): void {
  if (isFileName(name)) return
  read.fail(`${path} is not a valid file name`, name, `e.g. ${fileNamesOf([name])}`, 'choose another name')
}

function readShape(
  read: JsonReader,
  json: unknown,
  path: string,
  groups: ReadonlySet<string | undefined>,
): AreaShape {
  const field = read.object(json, path, ['polygon', 'group', 'radius', 'feather'])
  const feather = read.number(field.feather, `${path}.feather`, 0.1, 200, 'mm')
  if ((field.polygon === undefined) === (field.group === undefined)) {
    read.fail(`${path} must have exactly one kind of shape`, json, 'polygon or group', 'give one of the two')
  }
  if (field.polygon !== undefined) {
    if (field.radius !== undefined) {
      read.fail(`${path}.radius does not apply to a polygon`, field.radius, undefined, 'remove it')
    }
    return { polygon: read.points(field.polygon, `${path}.polygon`, 3), feather }
  }
  const group = read.name(field.group, `${path}.group`)
  if (!groups.has(group)) {
    const known = [...groups].filter((name) => name !== undefined).join(', ')
    read.fail(
      `${path}.group has no strokes`,
      group,
      known === '' ? 'none' : known,
      'use the name of a group of strokes',
    )
  }
  return { group, radius: read.number(field.radius, `${path}.radius`, 0, 100, 'mm'), feather }
}
