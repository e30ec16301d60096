import { FurrowError } from 'furrow'
import { JsonReader } from 'furrow/internal'
import { parseJson } from '../../base/json-file.ts'
import type { SourceFiles } from '../source-files.ts'

/** Kinds of maps of a set that Furrow's format has. */
export const SET_MAPS = ['Normal', 'Diffuse', 'Roughness', 'AO', 'Flow'] as const
export type SetMap = (typeof SET_MAPS)[number]

/** Number of sets of maps. */
export const SETS = [1, 2, 3] as const

/** Wrinkles of a material in Character Creator's JSON file. */
export interface CharacterWrinkles {
  mesh: string
  material: string
  /** Paths per set (1 to 3) and kind, relative to the folder. */
  textures: Readonly<Record<number, Partial<Record<SetMap, string>>>>
  /** Factors of rules by name. Missing rules have 1. */
  weights: ReadonlyMap<string, number>
  overallWeight: number
  unread: string[]
}

const FIELDS = [
  'Textures',
  'WrinkleRules',
  'WrinkleEaseStrength',
  'WrinkleRuleWeights',
  'WrinkleOverallWeight',
]
const MAX_RULES = 1024

/**
 * Finds the JSON files of a folder that may describe a character.
 *
 * @returns paths at the top of the folder.
 */
export function characterFiles({ paths, document }: SourceFiles): string[] {
  return document !== undefined ? [document] : paths.filter((path) => /^[^/]+\.json$/i.test(path))
}

/**
 * Reads the wrinkles of a character.
 *
 * @param path path of the JSON file.
 * @returns undefined if no material of the file has wrinkles.
 * @throws FurrowError if the file is malformed, or several materials have wrinkles.
 */
export async function readCharacter(
  files: SourceFiles,
  path: string,
  who: string,
): Promise<CharacterWrinkles | undefined> {
  const found = findWrinkles(parseJson(await files.read(path), path, who))
  if (found.length === 0) return undefined
  if (found.length > 1) {
    throw new FurrowError({
      who,
      problem: `several materials in ${path} have wrinkles`,
      value: found.map(({ material }) => material).join(', '),
      limit: 'one material',
      remedy: 'export one character per file',
    })
  }
  const [{ mesh, material, wrinkle, resources }] = found
  const reader = new JsonReader(`${who}: ${path}`)
  const fields = reader.object(wrinkle, 'Wrinkle')
  const unread = Object.keys(fields)
    .filter((key) => !FIELDS.includes(key))
    .map((key) => `${path}: Wrinkle.${key}`)
  if (fields.WrinkleEaseStrength !== undefined) unread.push(`${path}: Wrinkle.WrinkleEaseStrength`)
  unread.push(
    ...Object.keys(resources)
      .filter(isWrinkleResource)
      .map((key) => `${path}: Resource Textures.${key}`),
  )
  const textures = readTextures(reader, fields.Textures, path, unread)
  const { WrinkleOverallWeight: overall = 1 } = fields
  return {
    mesh,
    material,
    textures,
    weights: readWeights(reader, fields),
    overallWeight: reader.number(overall, 'Wrinkle.WrinkleOverallWeight', 0, 1000, ''),
    unread,
  }
}

const isWrinkleResource = (key: string) => /^wrinkle/i.test(key)

interface Found {
  mesh: string
  material: string
  wrinkle: unknown
  resources: object
}

/** Finds `Meshes.NAME.Materials.NAME.Wrinkle` at any depth. */
function findWrinkles(json: unknown, trail: readonly string[] = []): Found[] {
  if (typeof json !== 'object' || json === null || Array.isArray(json)) return []
  const fields = json as Record<string, unknown>
  const nameAfter = (key: string) => trail[trail.lastIndexOf(key) + 1] ?? ''
  const own = trail.includes('Materials') && fields.Wrinkle !== undefined
  const resources = fields['Resource Textures']
  const found: Found[] = own
    ? [
        {
          mesh: nameAfter('Meshes'),
          material: nameAfter('Materials'),
          wrinkle: fields.Wrinkle,
          resources: typeof resources === 'object' && resources !== null ? resources : {},
        },
      ]
    : []
  const others = Object.entries(fields).filter(([key]) => key !== 'Wrinkle')
  return [...found, ...others.flatMap(([key, value]) => findWrinkles(value, [...trail, key]))]
}

function readTextures(
  reader: JsonReader,
  value: unknown,
  path: string,
  unread: string[],
): Record<number, Partial<Record<SetMap, string>>> {
  const textures: Record<number, Partial<Record<SetMap, string>>> = { 1: {}, 2: {}, 3: {} }
  for (const [key, entry] of Object.entries(reader.object(value, 'Wrinkle.Textures'))) {
    const at = `Wrinkle.Textures.${key}`
    const [, kind, set] = /^([A-Za-z]+)_([123])$/.exec(key) ?? []
    const map = SET_MAPS.find((one) => one === kind)
    if (!map) {
      unread.push(`${path}: ${at}`)
      continue
    }
    const fields: Record<string, unknown> =
      typeof entry === 'string' ? { 'Texture Path': entry } : reader.object(entry, at)
    unread.push(
      ...Object.keys(fields)
        .filter((field) => field !== 'Texture Path')
        .map((field) => `${path}: ${at}.${field}`),
    )
    const file = fields['Texture Path']
    if (file === '' || file === undefined) continue
    textures[Number(set)][map] = reader
      .text(file, `${at}.Texture Path`, 2048)
      .replaceAll('\\', '/')
      .replace(/^\.\//, '')
  }
  return textures
}

function readWeights(reader: JsonReader, fields: Record<string, unknown>): Map<string, number> {
  const { WrinkleRules: rules, WrinkleRuleWeights: weights } = fields
  if (rules === undefined) return new Map()
  const names = reader.array(rules, 'Wrinkle.WrinkleRules', 0, MAX_RULES)
  const values = reader.array(weights, 'Wrinkle.WrinkleRuleWeights', names.length, names.length)
  return new Map(
    names.map((name, i) => [
      reader.text(name, `Wrinkle.WrinkleRules[${i}]`, 256),
      reader.number(values[i], `Wrinkle.WrinkleRuleWeights[${i}]`, 0, 1000, ''),
    ]),
  )
}
