import type { FurrowError } from '../../core/error.ts'
import { JsonReader, tryRead } from '../../core/json.ts'
import { MAX_LINKS, MAX_NAME_LENGTH } from '../../core/limits.ts'
import { didYouMean } from '../../core/nearest-name.ts'
import { canonicalTargetName, targetFinder } from '../../drivers/morph/target-names.ts'
import type { Skin, SkinTarget } from '../skin/surface.ts'
import { labelOf, SHAPE_NAMES } from './families.ts'
import { hintOf } from './names/hint.ts'
import type { NameHint } from './names/name-hint.ts'

/** Manual correction of a blendshape's recognised shape, in a file. */
export interface ShapeCorrection {
  /** Name of the mesh or its node; default: every mesh with the material. */
  mesh?: string
  /** Name of the blendshape, in any spelling that `findTargets` accepts. */
  target: string
  /** ARKit name, without its side if the blendshape moves both; undefined if it matches no ARKit shape. */
  shape?: string
}

/**
 * Reads the corrections of a file. Unknown fields are ignored.
 *
 * @param json `shapes` of the glTF extension or of `wrinkles.json`, of any type; undefined if missing.
 * @param who file name for errors.
 * @param onError called with the error of each malformed correction, which is skipped. Default: throw the first one.
 */
export function parseCorrections(
  json: unknown,
  who: string,
  onError: (error: FurrowError) => void = (error) => {
    throw error
  },
): ShapeCorrection[] {
  if (json === undefined) return []
  const reader = new JsonReader(who)
  const list = tryRead(() => reader.array(json, 'shapes', 0, MAX_LINKS), onError) ?? []
  return list.flatMap((item, i) => tryRead(() => readCorrection(reader, item, `shapes[${i}]`), onError) ?? [])
}

function readCorrection(reader: JsonReader, item: unknown, at: string): ShapeCorrection {
  const { mesh, target, shape } = reader.object(item, at)
  return {
    ...(mesh !== undefined && { mesh: reader.text(mesh, `${at}.mesh`, MAX_NAME_LENGTH) }),
    target: reader.text(target, `${at}.target`, MAX_NAME_LENGTH),
    ...(shape !== undefined && { shape: readShape(reader, shape, `${at}.shape`) }),
  }
}

function readShape(reader: JsonReader, value: unknown, at: string): string {
  const shape = reader.text(value, at, MAX_NAME_LENGTH)
  if (labelOf(shape)) return shape
  const remedy = didYouMean(shape, SHAPE_NAMES, 'omit it where the blendshape is none of these')
  return reader.fail(
    `${at} is unknown`,
    shape,
    "ARKit's name, with or without its side",
    remedy,
    'unknown-name',
  )
}

/**
 * Applies a material's corrections to its skin. If several name a blendshape, the first one wins.
 *
 * @param meshes names of the mesh and its nodes, or its index if unnamed.
 */
export function correctSkin(
  skin: Skin,
  corrections: readonly ShapeCorrection[],
  meshes: readonly string[],
): Skin {
  const own = corrections.filter(({ mesh }) => mesh === undefined || meshes.includes(mesh))
  if (own.length === 0) return skin
  const find = targetFinder(skin.targets.map(({ name }) => name))
  const found = new Map<number, string | null>()
  for (const { target, shape } of own)
    for (const index of find(target)) if (!found.has(index)) found.set(index, shape ?? null)
  const targets = skin.targets.map((target, i) =>
    found.has(i) ? { ...target, correction: found.get(i) } : target,
  )
  return { ...skin, targets }
}

type NamedTarget = Omit<SkinTarget, 'offsets'>

/** Derives a target's kind from its correction, its name, or the name of the expression that moves it. */
export function hintOfTarget({ name, expression, correction }: NamedTarget): NameHint | undefined {
  if (typeof correction === 'string') return hintOf(correction)
  const hint = hintOf(name) ?? (expression === undefined ? undefined : hintOf(expression))
  // A body slider keeps its kind.
  return correction === null && hint && hint.shapes.length > 0 ? undefined : hint
}

/** Returns the names used to find shapes. Corrections replace names; another target with a corrected name gets a placeholder. */
export function correctedNames(targets: readonly NamedTarget[]): string[] {
  const corrected = new Set(targets.map(({ correction }) => correction))
  return targets.map(({ name, correction }, i) => {
    if (typeof correction === 'string') return correction
    return correction === null || corrected.has(canonicalTargetName(name)) ? placeholderName(i) : name
  })
}

/** Placeholder name of a target, unlike any shape's. */
export function placeholderName(target: number): string {
  return `#${target}`
}
