import type { AreaConvention } from '../core/area.ts'
import { readSetDocument, type SetDocument } from '../core/document.ts'
import type { FurrowError } from '../core/error.ts'
import { JsonReader, orDefault, tryRead } from '../core/json.ts'
import { MAX_DRIVERS } from '../core/limits.ts'
import { WRINKLE_MAPS } from '../core/maps/declared.ts'
import { type MapsAndAreas, readMaps } from '../core/maps/wrinkle-maps.ts'
import { Fields } from './fields.ts'
import { definitionOf, type WrinkleDriver } from './registry.ts'

/** The JSON of the glTF extension on a material, checked and with defaults filled in. */
export interface WrinkleMaps extends MapsAndAreas {
  /** In the order of the file. */
  drivers: WrinkleDriver[]
}

/** `wrinkles.json`: a wrinkle set whose images are files beside it; their URLs are relative to it. */
export interface WrinkleSetDocument extends SetDocument {
  /** What activates the areas, as in the glTF extension. */
  drivers?: WrinkleDriver[]
}

/**
 * Reads the JSON of the glTF extension. Unknown fields are ignored, and drivers of unknown type are kept as they are.
 *
 * @param json the value of `material.extensions.FURROW_wrinkle_maps`, of any type.
 * @param textureCount number of textures in the file, to check indices against; not checked by default.
 * @param who names the file or material in errors.
 * @param onFault is told of each malformed driver, which is then left out; by default it is thrown.
 * @throws FurrowError that names the first field which is missing, has the wrong type or is out of range.
 */
export function parseWrinkleMaps(
  json: unknown,
  textureCount = Infinity,
  who: string = WRINKLE_MAPS,
  onFault?: (fault: FurrowError) => void,
): WrinkleMaps {
  const reader = new JsonReader(who)
  const { drivers, ...maps } = readMaps(reader, json, textureCount)
  return { ...maps, drivers: readDrivers(reader, drivers, maps.areas, onFault) }
}

/**
 * Reads `wrinkles.json`. Unknown fields are ignored, so that later versions may add some.
 *
 * @param json anything that `JSON.parse` can return.
 * @param who names the file in errors.
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
 * Reads drivers from JSON, as in files, and fills in their defaults. Drivers of unknown type are kept as they are.
 *
 * @param json a list of drivers, of any type; undefined for none.
 * @param areas names of the areas that drivers may use.
 * @param who names the caller in errors.
 * @throws FurrowError that names the first field which is missing, has the wrong type or is out of range.
 */
export function parseDrivers(json: unknown, areas: readonly string[], who = 'parseDrivers'): WrinkleDriver[] {
  const named = areas.map((name) => ({ name }))
  return readDrivers(new JsonReader(who), json, named)
}

function readDrivers(
  reader: JsonReader,
  value: unknown,
  areas: readonly { name: string }[],
  onFault: (fault: FurrowError) => void = (fault) => {
    throw fault
  },
): WrinkleDriver[] {
  const names = areas.map(({ name }) => name)
  const list = tryRead(() => reader.array(orDefault(value, []), 'drivers', 0, MAX_DRIVERS), onFault) ?? []
  return list.flatMap(
    (item, i) => tryRead(() => readDriver(reader, item, `drivers[${i}]`, names), onFault) ?? [],
  )
}

function readDriver(reader: JsonReader, item: unknown, at: string, areas: readonly string[]): WrinkleDriver {
  const json = reader.object(item, at)
  const type = reader.text(json.type, `${at}.type`)
  const definition = definitionOf(type)
  if (!definition) return { ...json, type }
  return { type, ...definition.read(new Fields(reader, json, at, areas)) }
}
