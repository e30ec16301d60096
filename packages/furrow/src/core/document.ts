import type { AreaConvention } from './area.ts'
import { JsonReader } from './json.ts'
import { MAX_AREAS, MAX_LAYERS } from './limits.ts'
import type { Combine, LayerKind } from './types.ts'

/** `wrinkles.json`: a wrinkle set whose images lie beside it as files. */
export interface WrinkleSetDocument {
  version: 1
  layers: {
    name: string
    kind: LayerKind
    /** Address of the tangent-space normal map, relative to the document. */
    normal: string
  }[]
  areas: {
    name: string
    /** Address of the gray image, relative to the document. */
    image: string
    layer?: string
    combine?: Combine
    convention?: AreaConvention
  }[]
}

/** Longest address of an image. */
const LONGEST_ADDRESS = 2048

/**
 * Reads the JSON of a wrinkle set. Unknown fields are left alone, so that later versions may add some.
 *
 * @param json anything `JSON.parse` can return.
 * @throws FurrowError that names the first field which is missing or has the wrong type.
 */
export function parseWrinkleSetDocument(json: unknown, who = 'wrinkles.json'): WrinkleSetDocument {
  const reader = new JsonReader(who)
  const root = reader.object(json, 'the document')
  if (root.version !== 1)
    reader.fail('unknown version', root.version, '1', 'write it in version 1 of the format')
  const layers = reader.array(root.layers, 'layers', 1, MAX_LAYERS).map((item, i) => {
    const at = `layers[${i}]`
    const layer = reader.object(item, at)
    return {
      name: reader.text(layer.name, `${at}.name`),
      kind: reader.choice(layer.kind ?? 'replace', `${at}.kind`, ['replace', 'detail']),
      normal: reader.text(layer.normal, `${at}.normal`, LONGEST_ADDRESS),
    }
  })
  const areas = reader.array(root.areas, 'areas', 1, MAX_AREAS).map((item, i) => {
    const at = `areas[${i}]`
    const area = reader.object(item, at)
    return {
      name: reader.text(area.name, `${at}.name`),
      image: reader.text(area.image, `${at}.image`, LONGEST_ADDRESS),
      ...(area.layer !== undefined && { layer: reader.text(area.layer, `${at}.layer`) }),
      combine: reader.choice(area.combine ?? 'sum', `${at}.combine`, ['sum', 'max']),
      convention: reader.choice(area.convention ?? 'paper', `${at}.convention`, ['paper', 'weight']),
    }
  })
  return { version: 1, layers, areas }
}
