import type { FurrowError } from '../../core/error.ts'
import { JsonReader, tryRead } from '../../core/json.ts'
import { MAX_LINKS, MAX_NAME_LENGTH } from '../../core/limits.ts'
import { didYouMean } from '../../core/nearest-name.ts'
import { canonicalTargetName, targetFinder } from '../../drivers/morph/target-names.ts'
import type { Skin, SkinTarget } from '../skin/surface.ts'
import { labelOf, SHAPE_NAMES } from './families.ts'
import { hintOf } from './names/hint.ts'
import type { NameHint } from './names/name-hint.ts'

/** Correction by the user: the ARKit shape that a blendshape has. It overrides the automatic recognition, and is stored in a file. */
export interface ShapeCorrection {
  /** Name of the mesh or its node. Default: every mesh that has the material of the wrinkles. */
  mesh?: string
  /** Name of the blendshape, in any spelling that `findTargets` accepts. */
  target: string
  /** ARKit name, without `Left` or `Right` if the blendshape moves both sides. Undefined if the blendshape matches no ARKit shape. */
  shape?: string
}

/**
 * Reads the shape corrections of a file. Unknown fields are ignored.
 *
 * @param json value of the field `shapes` of the glTF extension or of `wrinkles.json`; undefined if the field is missing.
 * @param who file name for errors.
 * @param onError called with an error for each malformed correction; these corrections are skipped. Default: throw the first error.
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
 * Stores corrections in the targets of a skin. If several corrections name a blendshape, the first one wins.
 *
 * @param meshes names of the skin's mesh and its nodes; the index of the mesh if it has no name.
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

/** Guesses a target's kind from its correction, its name, or the name of the VRM expression that moves it. */
export function hintOfTarget({ name, expression, correction }: NamedTarget): NameHint | undefined {
  if (typeof correction === 'string') return hintOf(correction)
  const hint = hintOf(name) ?? (expression === undefined ? undefined : hintOf(expression))
  // A correction of `null` rejects ARKit shapes only: kinds without them, such as `body`, still apply.
  return correction === null && hint && hint.shapes.length > 0 ? undefined : hint
}

/**
 * Returns the names by which drivers find targets. A corrected target has the name of its correction. If another target already has this
 * name, that target gets a placeholder name, so that only the corrected target is found.
 */
export function correctedNames(targets: readonly NamedTarget[]): string[] {
  const corrected = new Set(targets.map(({ correction }) => correction))
  return targets.map(({ name, correction }, i) => {
    if (typeof correction === 'string') return correction
    return correction === null || corrected.has(canonicalTargetName(name)) ? placeholderName(i) : name
  })
}

/** Returns a name for a target that no shape has. */
export function placeholderName(target: number): string {
  return `#${target}`
}
