import type { FurrowError } from '../../core/error.ts'
import { JsonReader, unlessFaulty } from '../../core/json.ts'
import { LONGEST_NAME, MAX_LINKS } from '../../core/limits.ts'
import { didYouMean } from '../../core/nearest-name.ts'
import { canonicalTargetName, targetFinder } from '../../drivers/morph/target-names.ts'
import type { Skin, SkinTarget } from '../skin/surface.ts'
import { labelOf, SHAPE_NAMES } from './families.ts'
import { hintOf } from './names/hint.ts'
import type { NameHint } from './names/name-hint.ts'

/** A correction of what a blendshape was recognised as, in a file. */
export interface ShapeCorrection {
  /** Name of the mesh or of its node; by default every mesh with the material. */
  mesh?: string
  /** Name of the blendshape, in any spelling that `findTargets` knows. */
  target: string
  /** ARKit's name, without its side where the blendshape moves both sides; absent where it is none of ARKit's shapes. */
  shape?: string
}

/**
 * Reads the corrections of a file. Unknown fields are left out.
 *
 * @param json `shapes` of the glTF extension or of `wrinkles.json`, of any type; undefined for none.
 * @param who names the file in errors.
 * @param onFault receives the error of each malformed correction, which is left out; by default the first one is thrown.
 */
export function parseCorrections(
  json: unknown,
  who: string,
  onFault: (fault: FurrowError) => void = (fault) => {
    throw fault
  },
): ShapeCorrection[] {
  if (json === undefined) return []
  const reader = new JsonReader(who)
  const list = unlessFaulty(() => reader.array(json, 'shapes', 0, MAX_LINKS), onFault) ?? []
  return list.flatMap(
    (item, i) => unlessFaulty(() => readCorrection(reader, item, `shapes[${i}]`), onFault) ?? [],
  )
}

function readCorrection(reader: JsonReader, item: unknown, at: string): ShapeCorrection {
  const { mesh, target, shape } = reader.object(item, at)
  return {
    ...(mesh !== undefined && { mesh: reader.text(mesh, `${at}.mesh`, LONGEST_NAME) }),
    target: reader.text(target, `${at}.target`, LONGEST_NAME),
    ...(shape !== undefined && { shape: readShape(reader, shape, `${at}.shape`) }),
  }
}

function readShape(reader: JsonReader, value: unknown, at: string): string {
  const shape = reader.text(value, at, LONGEST_NAME)
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
 * Applies the corrections of a material to its skin. The first that names a blendshape counts.
 *
 * @param meshes names of the mesh: its own and those of its nodes, or its index where it has none.
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

/** Kind of a target by its correction, or by its name, or by that of the expression that moves it. */
export function hintOfTarget({ name, expression, correction }: NamedTarget): NameHint | undefined {
  if (typeof correction === 'string') return hintOf(correction)
  const hint = hintOf(name) ?? (expression === undefined ? undefined : hintOf(expression))
  // A body slider stays one.
  return correction === null && hint && hint.shapes.length > 0 ? undefined : hint
}

/** Names by which shapes are found: a correction counts as the name. Another target of that name has none. */
export function correctedNames(targets: readonly NamedTarget[]): string[] {
  const corrected = new Set(targets.map(({ correction }) => correction))
  return targets.map(({ name, correction }, i) => {
    if (typeof correction === 'string') return correction
    return correction === null || corrected.has(canonicalTargetName(name)) ? nameless(i) : name
  })
}

/** A name of a target that means nothing. */
export function nameless(target: number): string {
  return `#${target}`
}
