import type { AreaConvention } from './area.ts'
import { FurrowError } from './error.ts'
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

type Json = Record<string, unknown>

/**
 * Reads the JSON of a wrinkle set. Unknown fields are left alone, so that later versions may add some.
 *
 * @param json anything `JSON.parse` can return.
 * @throws FurrowError that names the first field which is missing or has the wrong type.
 */
export function parseWrinkleSetDocument(json: unknown, who = 'wrinkles.json'): WrinkleSetDocument {
  const root = object(json, 'the document', who)
  if (root.version !== 1) {
    throw fault(who, 'version', root.version, '1', 'write it in version 1 of the format')
  }
  const layers = list(root.layers, 'layers', who).map((item, i) => {
    const layer = object(item, `layers[${i}]`, who)
    return {
      name: text(layer.name, `layers[${i}].name`, who),
      kind: choice(layer.kind ?? 'replace', ['replace', 'detail'] as const, `layers[${i}].kind`, who),
      normal: text(layer.normal, `layers[${i}].normal`, who),
    }
  })
  const areas = list(root.areas, 'areas', who).map((item, i) => {
    const area = object(item, `areas[${i}]`, who)
    const at = `areas[${i}]`
    return {
      name: text(area.name, `${at}.name`, who),
      image: text(area.image, `${at}.image`, who),
      ...(area.layer !== undefined && { layer: text(area.layer, `${at}.layer`, who) }),
      combine: choice(area.combine ?? 'sum', ['sum', 'max'] as const, `${at}.combine`, who),
      convention: choice(area.convention ?? 'paper', ['paper', 'weight'] as const, `${at}.convention`, who),
    }
  })
  return { version: 1, layers, areas }
}

function object(value: unknown, field: string, who: string): Json {
  if (typeof value === 'object' && value !== null && !Array.isArray(value)) return value as Json
  throw fault(who, field, value, 'an object', 'write { ... } there')
}

function list(value: unknown, field: string, who: string): unknown[] {
  if (Array.isArray(value)) return value
  throw fault(who, field, value, 'a list', 'write [ ... ] there')
}

function text(value: unknown, field: string, who: string): string {
  if (typeof value === 'string' && value !== '') return value
  throw fault(who, field, value, 'a text that is not empty', 'write "..." there')
}

function choice<T extends string>(value: unknown, allowed: readonly T[], field: string, who: string): T {
  if (allowed.includes(value as T)) return value as T
  throw fault(who, field, value, allowed.join(' or '), 'use one of them')
}

function fault(who: string, field: string, value: unknown, limit: string, remedy: string): FurrowError {
  return new FurrowError({
    who,
    what: `bad "${field}"`,
    value: JSON.stringify(value) ?? 'nothing',
    limit,
    remedy,
  })
}
