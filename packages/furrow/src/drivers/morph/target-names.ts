import { ALIASES } from './aliases.ts'

/** What exporters put before a name: `blendShape1.`, `Face.M_F00_000_00_`, `BS_`. */
const PREFIXES = [/^.*\.(?=[^.]{2})/, /^M_F\d+(_\d+)*_/i, /^BS_/i]

/**
 * Maps a blendshape name to the targets of one mesh. Rigs write the same shape as `browOuterUpLeft`, `browOuterUp_L`,
 * `BrowOuterUp.L` or `blendShape1.browOuterUpLeft`, or give it a name of their own (`ALIASES`); some split a central shape in
 * two (`browInnerUp_L`, `browInnerUp_R`), and then both are meant.
 *
 * @param name the mesh's own name, which comes first, or the shape in any of these spellings.
 * @param targets the mesh's names.
 * @returns indices into `targets`; empty when the mesh has no such shape.
 */
export function findTargets(name: string, targets: readonly string[]): number[] {
  return targetFinder(targets)(name)
}

/** `findTargets` for many names on one mesh. */
export function targetFinder(targets: readonly string[]): (name: string) => number[] {
  const plain = targets.map((target) => keyOf(canonicalTargetName(target)))
  return (name) => {
    const own = targets.indexOf(name)
    if (own >= 0) return [own]
    const wanted = keyOf(canonicalTargetName(name))
    const exact = plain.indexOf(wanted)
    if (exact >= 0) return [exact]
    return [plain.indexOf(`${wanted}left`), plain.indexOf(`${wanted}right`)].filter((index) => index >= 0)
  }
}

/** `blendShape1.browOuterUp_L` -> `browOuterUpLeft`: the name used here, or without prefix where the shape is not known here. */
export function canonicalTargetName(name: string): string {
  const known = CANONICAL.get(keyOf(name))
  if (known) return known
  const plain = withSide(PREFIXES.reduce((rest, prefix) => rest.replace(prefix, ''), name))
  return CANONICAL.get(keyOf(plain)) ?? plain
}

/** `_L`, `.L` or ` L` at the end is the left side. */
function withSide(name: string): string {
  return name.replace(/[_. -]L$/, 'Left').replace(/[_. -]R$/, 'Right')
}

/** Spellings that differ by capitals and separators have the same key. */
function keyOf(name: string): string {
  const letters = withSide(name)
    .toLowerCase()
    .replace(/[^\p{L}\p{N}]/gu, '')
  return letters || name
}

const CANONICAL: ReadonlyMap<string, string> = new Map(
  ALIASES.flatMap((names) => names.map((name) => [keyOf(name), names[0]] as const)),
)
