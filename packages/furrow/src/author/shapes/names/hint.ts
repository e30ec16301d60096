import { canonicalTargetName } from '../../../drivers/morph/target-names.ts'
import { knownShape } from './known-shapes.ts'
import type { NameHint, ShapeKind } from './name-hint.ts'
import { kindByWords } from './other-kinds.ts'

/** Prefixes without a separator after them. */
const GLUED = /^e?CTRL(?=[A-Z])/
/** Suffixes that exporters add: Blender's `.001`, Daz' `_div2`, Maya's `Shape`. */
const ENDS = /([._](\d{3,}|div2|bs|shape|morph|blendshape))+$|(?<=\p{Ll})Shape$/iu
/** Words that must not be dropped like prefixes, because the rest of the name would mean another shape. */
const PARTS_OF_FACES =
  /^(brows?|brw|eyes?|eyelids?|lids?|lash(es)?|cheeks?|nose|mouth|mth|ha|hair|lips?|jaw|chin|tongue|teeth|ears?|neck|no|not|non|un)\d*$/i

/**
 * Guesses from its name what a blendshape does. The function knows the names of common rigs, and ignores prefixes and suffixes that exporters
 * add. The result is only a hint, because the names in files can be wrong.
 *
 * @returns undefined if the name is unknown.
 */
export function hintOf(name: string): NameHint | undefined {
  const plain = name
    .normalize('NFKC')
    .replace(ENDS, '')
    .replace(/^.*[|:]/, '')
  const known = lookUp(plain)
  if (known) return known
  const kind = kindByWords(plain)
  if (kind === 'corrective' || kind === 'hidden') return hintOfKind(kind)
  return withoutPrefixes(plain.split(/[\s._-]+/)) ?? (kind && hintOfKind(kind))
}

/**
 * Returns the ARKit name if a blendshape equals an ARKit shape or is a part of one. Otherwise, returns the blendshape's name in the spelling
 * of `canonicalTargetName`.
 */
export function shapeNameOf(name: string, hint: NameHint | undefined): string {
  if (!hint || hint.match === 'like' || hint.shapes.length !== 1) return canonicalTargetName(name)
  const [shape] = hint.shapes
  return hint.match === 'part' && hint.side && !shape.endsWith(hint.side) ? `${shape}${hint.side}` : shape
}

function lookUp(name: string): NameHint | undefined {
  return knownShape(name) ?? knownShape(canonicalTargetName(name))
}

function hintOfKind(kind: ShapeKind): NameHint {
  return { kind, shapes: [], match: 'like', side: undefined, rank: 0 }
}

function withoutPrefixes(words: readonly string[]): NameHint | undefined {
  for (let first = 0; first < words.length; first++) {
    const rest = words.slice(first).join('_')
    const known = lookUp(rest) ?? lookUp(rest.replace(GLUED, ''))
    // A name that combines two shapes is a corrective.
    if (known) return withoutPrefixes(words.slice(0, first)) ? hintOfKind('corrective') : known
    if (PARTS_OF_FACES.test(words[first])) return undefined
  }
  return undefined
}
