import type { JsonReader, Uv } from '../../core/json.ts'

/** A soft shape: the inside of a polygon, or all that lies near the strokes of a group. */
export type AreaShape = PolygonShape | GroupShape

export interface PolygonShape {
  /** At least 3 points [u, v], 0..1; the last is joined to the first. */
  polygon: Uv[]
  /** Millimetres, 0.1..200, over which the weight falls from 1 to 0; the outline lies in the middle, at 0.5. */
  feather: number
}

export interface GroupShape {
  /** Name of a group of strokes in the same document. */
  group: string
  /** Distance from the strokes in millimetres, 0..100, where the weight is 0.5. */
  radius: number
  /** As in PolygonShape. */
  feather: number
}

/** How an area is made: the largest of its shapes at every texel, times `within` where that is given. */
export interface AreaSketch {
  name: string
  shapes: AreaShape[]
  /** Keeps the area to one side, e.g. to the person's left half with a soft blend at the middle. */
  within?: AreaShape
}

/** Reads the `areas` of a strokes document. Throws FurrowError through `read`. */
export function readSketches(
  read: JsonReader,
  sketches: unknown[],
  groups: ReadonlySet<string | undefined>,
): AreaSketch[] {
  const names = new Set<string>()
  return sketches.map((json, i) => {
    const path = `areas[${i}]`
    const field = read.object(json, path, ['name', 'shapes', 'within'])
    const name = read.text(field.name, `${path}.name`)
    // The name becomes a file's name, and it must stay inside the folder the user chose.
    if (!/^[A-Za-z0-9_-]+$/.test(name)) {
      read.fail(`${path}.name cannot name a file`, name, 'letters, digits, _ and -', 'choose another name')
    }
    if (names.has(name)) read.fail(`${path}.name is taken`, name, undefined, 'give every area its own name')
    names.add(name)
    const shapes = read
      .array(field.shapes, `${path}.shapes`, 1, 100)
      .map((shape, k) => readShape(read, shape, `${path}.shapes[${k}]`, groups))
    const sketch: AreaSketch = { name, shapes }
    if (field.within !== undefined) {
      sketch.within = readShape(read, field.within, `${path}.within`, groups)
    }
    return sketch
  })
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
    read.fail(`${path} is neither one shape nor the other`, json, 'polygon, or group', 'give one of the two')
  }
  if (field.polygon !== undefined) {
    if (field.radius !== undefined) {
      read.fail(`${path}.radius has no meaning for a polygon`, field.radius, undefined, 'remove it')
    }
    return { polygon: read.points(field.polygon, `${path}.polygon`, 3), feather }
  }
  const group = read.text(field.group, `${path}.group`)
  if (!groups.has(group)) {
    const known = [...groups].filter((name) => name !== undefined).join(', ')
    read.fail(`${path}.group has no strokes`, group, known === '' ? 'none' : known, 'name a group of strokes')
  }
  return { group, radius: read.number(field.radius, `${path}.radius`, 0, 100, 'mm'), feather }
}
