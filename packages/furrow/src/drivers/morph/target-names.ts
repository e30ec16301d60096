import { ALIASES } from './aliases.ts'

/** Prefixes that exporters add: `blendShape1.`, `Face.M_F00_000_00_`, `BS_`. */
const PREFIXES = [/^.*\.(?=[^.]{2})/, /^M_F\d+(_\d+)*_/i, /^BS_/i]

/**
 * Finds the morph targets of a mesh for a blendshape name. Rigs spell a shape `browOuterUpLeft`, `browOuterUp_L`, `BrowOuterUp.L` or
 * `blendShape1.browOuterUpLeft`, or use another name (`ALIASES`). If a rig splits a central shape (`browInnerUp_L`, `browInnerUp_R`), both
 * are returned.
 *
 * @param name name in any of these spellings; an exact match takes precedence.
 * @param targets names of the mesh's targets.
 * @returns indices into `targets`; empty if the mesh has no such shape.
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

/** Returns the canonical name of a blendshape, e.g. `browOuterUpLeft` for `blendShape1.browOuterUp_L`; otherwise the name without prefix. */
export function canonicalTargetName(name: string): string {
  const known = CANONICAL.get(keyOf(name))
  if (known) return known
  const plain = withSide(PREFIXES.reduce((rest, prefix) => rest.replace(prefix, ''), name))
  return CANONICAL.get(keyOf(plain)) ?? plain
}

/** Spells out a side at the end: `_L`, `.L`, `-L` or ` L` becomes `Left`. */
function withSide(name: string): string {
  return name.replace(/[_. -]L$/, 'Left').replace(/[_. -]R$/, 'Right')
}

/** Returns a key that ignores capitals and separators. */
function keyOf(name: string): string {
  const letters = withSide(name)
    .toLowerCase()
    .replace(/[^\p{L}\p{N}]/gu, '')
  return letters || name
}

const CANONICAL: ReadonlyMap<string, string> = new Map(
  ALIASES.flatMap((names) => names.map((name) => [keyOf(name), names[0]] as const)),
)
