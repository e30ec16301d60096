import { ALIASES } from './aliases.ts'

/** Prefixes that exporters add, such as `blendShape1.`, `Face.M_F00_000_00_` and `BS_`. */
const PREFIXES = [/^.*\.(?=[^.]{2})/, /^M_F\d+(_\d+)*_/i, /^BS_/i]

/**
 * Finds the morph targets of a mesh for a blendshape name. Rigs spell a blendshape `browOuterUpLeft`, `browOuterUp_L`, `BrowOuterUp.L` or
 * `blendShape1.browOuterUpLeft`, or use another name in `ALIASES`. If a rig splits a shape such as `browInnerUp` into a left and a right
 * target, both are returned.
 *
 * @param name name in any spelling. A target with exactly this name takes precedence.
 * @param targets names of the mesh's targets.
 * @returns indices into `targets`; empty if the mesh has no such shape.
 */
export function findTargets(name: string, targets: readonly string[]): number[] {
  return targetFinder(targets)(name)
}

/** Returns a function that does the same as `findTargets` for one mesh. It is faster for many names. */
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

/** Returns the canonical name of a blendshape, e.g. `browOuterUpLeft` for `blendShape1.browOuterUp_L`. Unknown names lose their prefix. */
export function canonicalTargetName(name: string): string {
  const known = CANONICAL.get(keyOf(name))
  if (known) return known
  const plain = withSide(PREFIXES.reduce((rest, prefix) => rest.replace(prefix, ''), name))
  return CANONICAL.get(keyOf(plain)) ?? plain
}

/** Replaces `_L`, `.L`, `-L` or ` L` at the end of a name by `Left`, and the same for `Right`. */
function withSide(name: string): string {
  return name.replace(/[_. -]L$/, 'Left').replace(/[_. -]R$/, 'Right')
}

/** Converts a name to a key, such that names that differ only in capitals and separators have the same key. */
function keyOf(name: string): string {
  const letters = withSide(name)
    .toLowerCase()
    .replace(/[^\p{L}\p{N}]/gu, '')
  return letters || name
}

const CANONICAL: ReadonlyMap<string, string> = new Map(
  ALIASES.flatMap((names) => names.map((name) => [keyOf(name), names[0]] as const)),
)
