import type { AreaConvention } from '../core/area.ts'
import { readSetDocument, type SetDocument } from '../core/document.ts'
import { JsonReader, or } from '../core/json.ts'
import { type MapsAndAreas, readMaps, WRINKLE_MAPS } from '../core/wrinkle-maps.ts'
import { Fields } from './fields.ts'
import { definitionOf, type WrinkleDriver } from './registry.ts'

const MAX_DRIVERS = 4096

/** The JSON of the glTF extension on a material, checked, defaults filled in. */
export interface WrinkleMaps extends MapsAndAreas {
  drivers: WrinkleDriver[]
}

/** `wrinkles.json`: a wrinkle set whose images are files beside it; all addresses are relative to it. */
export interface WrinkleSetDocument extends SetDocument {
  /** What activates the areas, as in the glTF extension. */
  drivers?: WrinkleDriver[]
}

/**
 * Reads the JSON of the glTF extension. Unknown fields are ignored; drivers of unknown type are kept as they are.
 *
 * @param json the value of `material.extensions.FURROW_wrinkle_maps`, whatever it is.
 * @param textureCount number of textures in the file, if known, to check indices against.
 * @throws FurrowError that names the first field which is missing, has the wrong type or is out of range.
 */
export function parseWrinkleMaps(
  json: unknown,
  textureCount = Infinity,
  who: string = WRINKLE_MAPS,
): WrinkleMaps {
  const reader = new JsonReader(who)
  const { drivers, ...maps } = readMaps(reader, json, textureCount)
  return { ...maps, drivers: readDrivers(reader, drivers, maps.areas) }
}

/**
 * Reads `wrinkles.json`. Unknown fields are ignored, so that later versions may add some.
 *
 * @param json anything `JSON.parse` can return.
 * @param convention of areas that do not name one.
 * @throws FurrowError that names the first field which is missing, has the wrong type or is out of range.
 */
export function parseWrinkleSetDocument(
  json: unknown,
  who = 'wrinkles.json',
  convention: AreaConvention = 'paper',
): WrinkleSetDocument {
  const reader = new JsonReader(who)
  const { drivers, ...document } = readSetDocument(reader, json, convention)
  return {
    ...document,
    ...(drivers !== undefined && { drivers: readDrivers(reader, drivers, document.areas) }),
  }
}

/**
 * Reads drivers from JSON as files hold them, and fills in their defaults.
 *
 * @param json a list of drivers, whatever it is.
 * @param areas names that drivers may use.
 * @throws FurrowError that names the first field which is missing, has the wrong type or is out of range.
 */
export function parseDrivers(json: unknown, areas: readonly string[], who = 'parseDrivers'): WrinkleDriver[] {
  const named = areas.map((name) => ({ name }))
  return readDrivers(new JsonReader(who), json, named)
}

/** Reads a list of drivers; none when it is absent. Those of unknown type are kept as they are. */
function readDrivers(
  reader: JsonReader,
  value: unknown,
  areas: readonly { name: string }[],
): WrinkleDriver[] {
  const names = areas.map(({ name }) => name)
  return reader.array(or(value, []), 'drivers', 0, MAX_DRIVERS).map((item, i) => {
    const at = `drivers[${i}]`
    const json = reader.object(item, at)
    const type = reader.text(json.type, `${at}.type`)
    const definition = definitionOf(type)
    if (!definition) return { ...json, type }
    return { type, ...definition.read(new Fields(reader, json, at, names)) }
  })
}
