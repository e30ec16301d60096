import { BOTH_SIDES, CENTRAL } from '../../../drivers/morph/aliases.ts'
import type { NameHint, ShapeKind } from './name-hint.ts'
import type { RigNames } from './rig-names.ts'
import { RIGS } from './rigs/index.ts'

type Side = 'Left' | 'Right'

/** Words for left and right in names of blendshapes. */
const SPELLINGS: readonly (readonly [Side, readonly string[]])[] = [
  ['Left', ['Left', 'L', '左']],
  ['Right', ['Right', 'R', '右']],
]

/** Boundaries between words without a separator. A capital L or R at either end of a name is a word, unless the name is all capitals. */
const BOUNDARIES = [
  /(?<=[\p{Ll}\d])(?=\p{Lu})/gu,
  /(?<=\p{Ll}.*\p{Lu})(?=[LR]$)/u,
  /(?<=^[LR])(?=\p{Lu}\p{Ll})/u,
]

/** Table of all known names, created at the first lookup. */
let known: Map<string, NameHint> | undefined

/** Looks up a name in all rigs, ignoring case and separators; undefined if unknown. */
export function knownShape(name: string): NameHint | undefined {
  known ??= allNames()
  return known.get(keyOf(name))
}

/** Removes case and separators from a name. Puts the words `l` and `r` in parentheses, so that `browRaise_R` differs from `browRaiser`. */
function keyOf(name: string): string {
  const words = BOUNDARIES.reduce((rest, boundary) => rest.replace(boundary, ' '), name)
    .toLowerCase()
    .split(/[^\p{L}\p{N}]+/u)
  return words.map((word) => (word === 'l' || word === 'r' ? `(${word})` : word)).join('') || name
}

function allNames(): Map<string, NameHint> {
  const found = new Map<string, NameHint>()
  const rows = [arkit(), ...RIGS].flatMap(rowsOf)
  // A name in a rig's table takes precedence over an equal name that is formed by adding a side.
  for (const withSide of [false, true]) {
    for (const [rank, row] of rows.entries()) {
      for (const [name, side] of withSide ? sidedNames(row.name) : [[row.name, undefined] as const]) {
        const key = keyOf(name)
        if (!found.has(key)) found.set(key, hintOfRow(row, side, rank))
      }
    }
  }
  return found
}

function arkit(): RigNames {
  const source = 'https://developer.apple.com/documentation/arkit/arfaceanchor/blendshapelocation'
  return { source, same: Object.fromEntries([...BOTH_SIDES, ...CENTRAL].map((name) => [name, name])) }
}

interface Row {
  name: string
  kind: ShapeKind
  match: NameHint['match']
  /** See `RigNames`. */
  shapes: string
}

function rowsOf({ same, parts, like, visemes, emotions, other = [] }: RigNames): Row[] {
  const rows = (names: Readonly<Record<string, string>> = {}, kind: ShapeKind, match: NameHint['match']) =>
    Object.entries(names).map(([name, shapes]): Row => ({ name, kind, match, shapes }))
  return [
    ...rows(same, 'expression', 'same'),
    ...rows(parts, 'expression', 'part'),
    ...rows(like, 'expression', 'like'),
    ...rows(visemes, 'viseme', 'like'),
    ...rows(emotions, 'emotion', 'like'),
    ...other.map((name): Row => ({ name, kind: 'other', match: 'like', shapes: '' })),
  ]
}

function sidedNames(name: string): [name: string, side: Side][] {
  // Names without letters are symbols, which never include a side.
  if (!/\p{L}/u.test(name)) return []
  return SPELLINGS.flatMap(([side, words]) =>
    words
      .flatMap((word) =>
        name.includes('*') ? [name.replace('*', word)] : [`${name}_${word}`, `${word}_${name}`],
      )
      .map((spelled): [string, Side] => [spelled, side]),
  )
}

function hintOfRow({ kind, match, shapes }: Row, side: Side | undefined, rank: number): NameHint {
  const names = shapes.split(' ').filter((shape) => shape !== '')
  const found = names.flatMap((shape) => {
    const sides = shape.split('|')
    if (!BOTH_SIDES.includes(sides[0])) return shape
    const [left, right] = [sides[0], sides[1] ?? sides[0]]
    return [...(side === 'Right' ? [] : [`${left}Left`]), ...(side === 'Left' ? [] : [`${right}Right`])]
  })
  // True if the name contains a side, but ARKit has only one shape for both sides.
  const isHalf = match === 'same' && side !== undefined && found.length === 1 && CENTRAL.includes(found[0])
  return { kind, shapes: found, match: isHalf ? 'part' : match, side, rank }
}
