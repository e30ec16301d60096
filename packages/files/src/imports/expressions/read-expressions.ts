import { FurrowError } from 'furrow'
import { JsonReader, MAX_NAME_LENGTH } from 'furrow/internal'
import { parseJson } from '../../base/json-file.ts'
import { isImagePath, type SourceFiles } from '../source-files.ts'

/** Optional document beside the maps. */
export const EXPRESSIONS_FILE = 'expressions.json'

/** Kinds of maps beside the normal map, in file names such as `surprise_baseColor.png`. */
export const EXTRA_MAPS = ['baseColor', 'roughness', 'occlusion'] as const
export type ExtraMap = (typeof EXTRA_MAPS)[number]

/** Paths of the maps of one key frame. */
export interface KeyMaps extends Partial<Record<ExtraMap, string>> {
  normal: string
}

/** Maps at one weight of an expression. */
export interface KeyFrame extends KeyMaps {
  /** Weight of the expression at which the maps were captured, above 0 to 1. */
  at: number
}

/** An expression with its key frames, ordered by weight. */
export interface SourceExpression {
  name: string
  frames: KeyFrame[]
  /** Blendshapes that make the expression. Undefined if the source does not say. */
  targets?: { name: string; weight: number }[]
}

/** Expressions of a folder. */
export interface ExpressionSource {
  neutral: KeyMaps
  expressions: SourceExpression[]
  unread: string[]
}

const NEUTRAL = 'neutral'
const ROOT_FIELDS = ['neutral', 'expressions']
const ENTRY_FIELDS = ['name', 'at', 'normal', ...EXTRA_MAPS, 'targets']

/**
 * Reads the list of expressions: from `expressions.json`, or from the names of the images.
 *
 * @throws FurrowError if the document is malformed, or there is no neutral map or no expression.
 */
export async function readExpressions(files: SourceFiles, who: string): Promise<ExpressionSource> {
  const source = files.paths.includes(EXPRESSIONS_FILE)
    ? readDocument(parseJson(await files.read(EXPRESSIONS_FILE), EXPRESSIONS_FILE, who), files, who)
    : readNames(files)
  if (!source.neutral) throw incomplete(files, who, 'no neutral normal map', `${NEUTRAL}.png`)
  if (source.expressions.length === 0) {
    throw incomplete(files, who, 'no normal map of an expression', 'at least one, e.g. surprised.png')
  }
  return { ...source, neutral: source.neutral }
}

type FoundSource = Omit<ExpressionSource, 'neutral'> & { neutral?: KeyMaps }

/** Reads names such as `neutral.png`, `surprised.png`, `surprised_occlusion.png` and `surprised@0.5.png`. */
function readNames({ paths }: SourceFiles): FoundSource {
  const unread: string[] = []
  const found = new Map<string, Map<number, Partial<KeyMaps>>>()
  for (const path of paths) {
    const [, stem] = /^([^/]+)\.[^./]+$/.exec(path) ?? []
    if (stem === undefined || !isImagePath(path)) {
      unread.push(path)
      continue
    }
    const [, label, kind = 'normal'] = /^(.*?)(?:[_.-](normal|baseColor|roughness|occlusion))?$/i.exec(stem)!
    const [, name, at = '1'] = /^(.*?)(?:@(\d*\.?\d+))?$/.exec(label)!
    const map = ['normal', ...EXTRA_MAPS].find((one) => one.toLowerCase() === kind.toLowerCase())!
    const frames = found.get(name) ?? new Map<number, Partial<KeyMaps>>()
    found.set(name, frames.set(Number(at), { ...frames.get(Number(at)), [map]: path }))
  }
  const neutralName = [...found.keys()].find((name) => name.toLowerCase() === NEUTRAL)
  const neutral = neutralName === undefined ? undefined : found.get(neutralName)!.get(1)
  const expressions: SourceExpression[] = []
  for (const [name, frames] of found) {
    if (name === neutralName) continue
    const complete = [...frames].filter(([at, maps]) => maps.normal !== undefined && at > 0 && at <= 1)
    for (const [at, maps] of frames) {
      if (!complete.some(([other]) => other === at)) unread.push(...Object.values(maps))
    }
    const ordered = complete.sort(([a], [b]) => a - b).map(([at, maps]) => ({ at, ...maps }) as KeyFrame)
    if (ordered.length > 0) expressions.push({ name, frames: ordered })
  }
  return { ...(neutral?.normal !== undefined && { neutral: neutral as KeyMaps }), expressions, unread }
}

function readDocument(json: unknown, files: SourceFiles, who: string): FoundSource {
  const reader = new JsonReader(`${who}: ${EXPRESSIONS_FILE}`)
  const root = reader.object(json, 'the document')
  const unread = unknownFields(root, ROOT_FIELDS, '')
  const path = (value: unknown, at: string) => {
    const text = reader.text(value, at, 2048)
    if (files.paths.includes(text)) return text
    return reader.fail(`${at} names a missing image`, text, 'a path in the folder', 'correct the path')
  }
  const mapsOf = (value: unknown, at: string): KeyMaps => {
    const fields = reader.object(value, at)
    const extra = EXTRA_MAPS.filter((map) => fields[map] !== undefined)
    return {
      normal: path(fields.normal, `${at}.normal`),
      ...Object.fromEntries(extra.map((map) => [map, path(fields[map], `${at}.${map}`)])),
    }
  }
  const named = new Map<string, SourceExpression>()
  for (const [i, entry] of reader.array(root.expressions, 'expressions', 1, 256).entries()) {
    const at = `expressions[${i}]`
    const fields = reader.object(entry, at)
    unread.push(...unknownFields(fields, ENTRY_FIELDS, `${at}.`))
    const name = reader.name(fields.name, `${at}.name`)
    const weight = fields.at === undefined ? 1 : reader.number(fields.at, `${at}.at`, 0.001, 1, '')
    const known = named.get(name) ?? { name, frames: [] }
    known.frames.push({ at: weight, ...mapsOf(fields, at) })
    known.frames.sort((a, b) => a.at - b.at)
    if (fields.targets !== undefined) known.targets = targetsOf(reader, fields.targets, `${at}.targets`)
    named.set(name, known)
  }
  return { neutral: mapsOf(root.neutral, 'neutral'), expressions: [...named.values()], unread }
}

function targetsOf(reader: JsonReader, value: unknown, path: string) {
  return reader.array(value, path, 1, 256).map((target, i) => {
    const fields = reader.object(target, `${path}[${i}]`, ['name', 'weight'])
    const { weight = 1 } = fields
    return {
      name: reader.text(fields.name, `${path}[${i}].name`, MAX_NAME_LENGTH),
      weight: reader.number(weight, `${path}[${i}].weight`, -1000, 1000, ''),
    }
  })
}

function unknownFields(fields: object, known: readonly string[], path: string): string[] {
  return Object.keys(fields)
    .filter((key) => !known.includes(key))
    .map((key) => `${EXPRESSIONS_FILE}: ${path}${key}`)
}

function incomplete(files: SourceFiles, who: string, problem: string, limit: string): FurrowError {
  const remedy = `add it, or list the maps in ${EXPRESSIONS_FILE}`
  return new FurrowError({ who, problem: `${problem} in ${files.name}`, limit, remedy })
}
