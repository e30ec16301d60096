import { MAX_BLOOD_AMPLITUDE } from '../core/blood.ts'
import {
  LARGEST,
  LONGEST_NAME,
  MAX_AREAS,
  MAX_CURVE_POINTS,
  MAX_DRIVERS,
  MAX_LAYERS,
  MAX_LINKS,
} from '../core/limits.ts'
import { WRINKLE_MAPS } from '../core/maps/declared.ts'
import type { TextureReference, WrinkleMapsArea, WrinkleMapsLayer } from '../core/maps/wrinkle-maps.ts'
import { isName } from '../core/name.ts'
import { type Curve, IDENTITY } from './curve.ts'
import type { MorphDriver } from './morph/definition.ts'
import type { WrinkleMaps } from './parse.ts'

/** What is read here: every field is checked before it is used, and a field of what has none throws. */
// biome-ignore lint/suspicious/noExplicitAny: JSON of any shape
type Json = any

/**
 * Reads the JSON of the glTF extension as most files have it: declared, sound, its maps images of their own that are not KTX 2, its drivers
 * sums of blendshapes. Undefined for any other, which `parseWrinkleMaps` reads, or refuses with the reason: a page need not fetch that for most
 * files. What is returned is what that returns.
 *
 * @param file JSON of the whole file.
 */
export function readUsualMaps(json: Json, { extensionsUsed, textures }: Json): WrinkleMaps | undefined {
  try {
    const { drivers = [] } = json
    require(list(extensionsUsed).includes(WRINKLE_MAPS))
    const images = list(textures)
    const layers = list(json.layers, 1, MAX_LAYERS).map((layer) => readLayer(layer, images))
    const areas = list(json.areas, 1, MAX_AREAS).map((area) => readArea(area, images, layers.length))
    namesOf(layers)
    const names = namesOf(areas)
    return { layers, areas, drivers: list(drivers, 0, MAX_DRIVERS).map((driver) => readMorph(driver, names)) }
  } catch {
    return undefined
  }
}

/** The maps of a layer, and what scales each: the field, its range, and its default if it may be left out. */
const MAPS: Record<string, readonly [field: string, low: number, high: number, byDefault?: number] | null> = {
  normalTexture: ['scale', -LARGEST, LARGEST, 1],
  baseColorTexture: null,
  roughnessTexture: null,
  occlusionTexture: ['strength', 0, 1, 1],
  heightTexture: ['amplitude', 0, LARGEST],
  bloodTexture: ['amplitude', 0, MAX_BLOOD_AMPLITUDE],
}

function readLayer(json: Json, textures: Json[]): WrinkleMapsLayer {
  const layer: Json = { name: nameOf(json), kind: choice(json.kind, ['replace', 'detail']) }
  for (const [slot, scale] of Object.entries(MAPS)) {
    const map = json[slot]
    if (map === undefined) continue
    layer[slot] = readTexture(map, textures)
    if (!scale) continue
    const [field, low, high, byDefault] = scale
    const { [field]: value = byDefault } = map
    layer[slot][field] = number(value, low, high)
  }
  const { normalTexture, occlusionTexture, bloodTexture } = layer
  require(normalTexture)
  require(!occlusionTexture || !bloodTexture || occlusionTexture.index === bloodTexture.index)
  return layer
}

function readArea(json: Json, textures: Json[], layers: number): WrinkleMapsArea {
  const { layer = 0, channel = 0, activation = 0 } = json
  return {
    name: nameOf(json),
    layer: index(layer, layers),
    texture: readTexture(json.texture, textures),
    channel: index(channel, 4),
    combine: choice(json.combine, ['sum', 'max']),
    activation: number(activation, 0, 1),
  }
}

function readMorph(json: Json, areas: ReadonlySet<string>): MorphDriver {
  const { type, area, rule, targets, curve = IDENTITY } = json
  require(type === 'morph' && areas.has(area))
  return {
    type,
    area,
    targets: list(targets, 1, MAX_LINKS).map(({ name, weight = 1, curve }) => {
      require(curve === undefined)
      require(typeof name === 'string' && name !== '' && name.length <= LONGEST_NAME)
      return { name, weight: number(weight, -LARGEST, LARGEST) }
    }),
    rule: choice(rule, ['sum']),
    curve: readCurve(curve),
  }
}

function readCurve(json: Json): Curve {
  return list(json, 2, MAX_CURVE_POINTS).map((point, i) => {
    const [input, output] = list(point, 2, 2)
    require(i === 0 || input > json[i - 1][0])
    return [number(input, -LARGEST, LARGEST), number(output, 0, 1)]
  })
}

function readTexture(json: Json, textures: Json[]): TextureReference {
  const { extensions } = textures[index(json.index, textures.length)]
  require(json.slice === undefined && !extensions?.KHR_texture_basisu)
  return { ...json }
}

function require(isUsual: unknown): void {
  if (!isUsual) throw new Error()
}

function list(json: Json, low = 0, high = Infinity): Json[] {
  require(Array.isArray(json) && json.length >= low && json.length <= high)
  return json
}

function number(json: Json, low: number, high: number): number {
  require(typeof json === 'number' && json >= low && json <= high)
  return json
}

function index(json: Json, count: number): number {
  require(Number.isInteger(json))
  return number(json, 0, count - 1)
}

/** The first of the allowed values is the default. */
function choice<T extends string>(json: Json, allowed: readonly T[]): T {
  const [given] = json === undefined ? allowed : [json]
  require(allowed.includes(given))
  return given
}

function nameOf({ name }: Json): string {
  require(isName(name))
  return name
}

/** The names, each once. */
function namesOf(named: readonly { name: string }[]): Set<string> {
  const names = new Set(named.map(({ name }) => name))
  require(names.size === named.length)
  return names
}
