import type { AreaConvention } from '../core/area.ts'
import { readSetDocument, type SetDocument } from '../core/document.ts'
import type { FurrowError } from '../core/error.ts'
import { JsonReader, orDefault, tryRead } from '../core/json.ts'
import { MAX_DRIVERS } from '../core/limits.ts'
import { WRINKLE_MAPS } from '../core/maps/declared.ts'
import { type MapsAndAreas, readMaps } from '../core/maps/wrinkle-maps.ts'
import { Fields } from './fields.ts'
import { definitionOf, type WrinkleDriver } from './registry.ts'

/** JSON of the glTF extension FURROW_wrinkle_maps on a material, checked and with defaults filled in. */
export interface WrinkleMaps extends MapsAndAreas {
  /** Drivers in the order of the file. */
  drivers: WrinkleDriver[]
}

/** Contents of `wrinkles.json`: layers, areas and drivers. Images are separate files, with URLs relative to `wrinkles.json`. */
export interface WrinkleSetDocument extends SetDocument {
  /** Drivers in the order of the file, in the same format as in the glTF extension. */
  drivers?: WrinkleDriver[]
}

/**
 * Reads and checks the JSON of the glTF extension. Unknown fields are ignored. Drivers of unknown type are kept.
 *
 * @param json value of `material.extensions.FURROW_wrinkle_maps`, of any type.
 * @param textureCount number of textures in the file. Without it, indices of textures are not checked.
 * @param who name of the file or material in errors.
 * @param onError receives the errors of malformed drivers, which are skipped. By default, the first error is thrown.
 * @throws FurrowError naming the first field that is missing, has the wrong type or is out of range.
 */
export function parseWrinkleMaps(
  json: unknown,
  textureCount = Infinity,
  who: string = WRINKLE_MAPS,
  onError?: (error: FurrowError) => void,
): WrinkleMaps {
  const reader = new JsonReader(who)
  const { drivers, ...maps } = readMaps(reader, json, textureCount)
  return { ...maps, drivers: readDrivers(reader, drivers, maps.areas, onError) }
}

/**
 * Reads and checks `wrinkles.json`. Unknown fields are ignored, so that later versions can add fields.
 *
 * @param json result of `JSON.parse`.
 * @param who name of the file in errors.
 * @param convention meaning of gray in the images of areas that lack the field `convention`.
 * @throws FurrowError naming the first field that is missing, has the wrong type or is out of range.
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
 * Reads and checks drivers in the format of `wrinkles.json`, and fills in defaults. Drivers of unknown type are kept.
 *
 * @param json array of drivers, or undefined for no drivers.
 * @param areas names of the areas that drivers may use.
 * @param who name of the caller in errors.
 * @throws FurrowError naming the first field that is missing, has the wrong type or is out of range.
 */
export function parseDrivers(json: unknown, areas: readonly string[], who = 'parseDrivers'): WrinkleDriver[] {
  const named = areas.map((name) => ({ name }))
  return readDrivers(new JsonReader(who), json, named)
}

function readDrivers(
  reader: JsonReader,
  value: unknown,
  areas: readonly { name: string }[],
  onError: (error: FurrowError) => void = (error) => {
    throw error
  },
): WrinkleDriver[] {
  const names = areas.map(({ name }) => name)
  const list = tryRead(() => reader.array(orDefault(value, []), 'drivers', 0, MAX_DRIVERS), onError) ?? []
  return list.flatMap(
    (item, i) => tryRead(() => readDriver(reader, item, `drivers[${i}]`, names), onError) ?? [],
  )
}

function readDriver(reader: JsonReader, item: unknown, at: string, areas: readonly string[]): WrinkleDriver {
  const json = reader.object(item, at)
  const type = reader.text(json.type, `${at}.type`)
  const definition = definitionOf(type)
  if (!definition) return { ...json, type }
  return { type, ...definition.read(new Fields(reader, json, at, areas)) }
}
