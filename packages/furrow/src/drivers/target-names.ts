/**
 * Maps a blendshape name as ARKit spells it to the targets of one mesh. Rigs write the same shape as
 * `browOuterUpLeft`, `browOuterUp_L` or `blendShape1.browOuterUpLeft`; some split a central shape in two
 * (`browInnerUp_L`, `browInnerUp_R`), and then both are meant.
 *
 * @param name ARKit's spelling, e.g. `browInnerUp`.
 * @param targets the mesh's names, in any of these spellings.
 * @returns indices into `targets`; empty when the mesh has no such shape.
 */
export function findTargets(name: string, targets: readonly string[]): number[] {
  const plain = targets.map(canonicalTargetName)
  const exact = plain.indexOf(name)
  if (exact >= 0) return [exact]
  return [plain.indexOf(`${name}Left`), plain.indexOf(`${name}Right`)].filter((index) => index >= 0)
}

/** `blendShape1.browOuterUp_L` -> `browOuterUpLeft`. */
export function canonicalTargetName(name: string): string {
  return name
    .slice(name.lastIndexOf('.') + 1)
    .replace(/_L$/, 'Left')
    .replace(/_R$/, 'Right')
}
