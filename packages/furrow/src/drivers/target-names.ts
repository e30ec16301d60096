/**
 * Maps a blendshape name to the targets of one mesh. Rigs write the same shape as
 * `browOuterUpLeft`, `browOuterUp_L` or `blendShape1.browOuterUpLeft`; some split a central shape in two
 * (`browInnerUp_L`, `browInnerUp_R`), and then both are meant.
 *
 * @param name the mesh's own name, which comes first, or the shape in any of these spellings.
 * @param targets the mesh's names.
 * @returns indices into `targets`; empty when the mesh has no such shape.
 */
export function findTargets(name: string, targets: readonly string[]): number[] {
  const own = targets.indexOf(name)
  if (own >= 0) return [own]
  const plain = targets.map(canonicalTargetName)
  const wanted = canonicalTargetName(name)
  const exact = plain.indexOf(wanted)
  if (exact >= 0) return [exact]
  return [plain.indexOf(`${wanted}Left`), plain.indexOf(`${wanted}Right`)].filter((index) => index >= 0)
}

/** `blendShape1.browOuterUp_L` -> `browOuterUpLeft`. */
export function canonicalTargetName(name: string): string {
  return name
    .slice(name.lastIndexOf('.') + 1)
    .replace(/_L$/, 'Left')
    .replace(/_R$/, 'Right')
}
