import type { FurrowError } from '../../core/error.ts'
import { JsonReader, tryRead } from '../../core/json.ts'
import { MAX_LINKS, MAX_NAME_LENGTH } from '../../core/limits.ts'
import { didYouMean } from '../../core/nearest-name.ts'
import { canonicalTargetName, targetFinder } from '../../drivers/morph/target-names.ts'
import type { Skin, SkinTarget } from '../skin/surface.ts'
import { labelOf, SHAPE_NAMES } from './families.ts'
import { hintOf } from './names/hint.ts'
import type { NameHint } from './names/name-hint.ts'

/** ARKit shape that the user assigned to a blendshape. Overrides the automatic recognition, and is stored in the face's file. */
export interface ShapeCorrection {
  /** Name of the mesh or its node. Default: every mesh whose material has wrinkles. */
  mesh?: string
  /** Name of the blendshape, in any spelling that `findTargets` accepts. */
  target: string
  /** ARKit name, without `Left` or `Right` if the blendshape moves both sides. Undefined if the blendshape matches no ARKit shape. */
  shape?: string
}

/**
 * Reads the shape corrections of a file. Unknown fields are ignored.
 *
 * @param json value of the field `shapes` in `wrinkles.json` or in Furrow's glTF extension; undefined if the field is missing.
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
  const remedy = didYouMean(shape, SHAPE_NAMES, 'omit "shape" if no ARKit shape matches')
  return reader.fail(
    `${at} is unknown`,
    shape,
    'an ARKit name, with or without Left or Right',
    remedy,
    'unknown-name',
  )
}

/**
 * Returns a skin whose targets contain their corrections. If several corrections name the same blendshape, the first one wins.
 *
 * @param meshes names of the skin's mesh and its nodes. If the mesh has no name, pass its index as a string.
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

/** Guesses what a blendshape does. Uses its correction, its name, or the name of the VRM expression that moves it. */
export function hintOfTarget({ name, expression, correction }: NamedTarget): NameHint | undefined {
  if (typeof correction === 'string') return hintOf(correction)
  const hint = hintOf(name) ?? (expression === undefined ? undefined : hintOf(expression))
  // A correction of `null` means that no ARKit shape matches, so a hint with ARKit shapes is wrong. A hint without shapes stays valid, for
  // example the hint that the target changes the proportions of the body.
  return correction === null && hint && hint.shapes.length > 0 ? undefined : hint
}

/**
 * Returns the names by which drivers (functions of blendshape weights) find targets. A corrected target has the ARKit name of its correction.
 * Other targets that already have this name get a placeholder name, so that only the corrected target is found. Targets with the correction
 * `null`, which match no ARKit shape, also get a placeholder name.
 */
export function correctedNames(targets: readonly NamedTarget[]): string[] {
  const corrected = new Set(targets.map(({ correction }) => correction))
  return targets.map(({ name, correction }, i) => {
    if (typeof correction === 'string') return correction
    return correction === null || corrected.has(canonicalTargetName(name)) ? placeholderName(i) : name
  })
}

/** Returns a placeholder name for a target. It differs from all ARKit names. */
export function placeholderName(target: number): string {
  return `#${target}`
}
