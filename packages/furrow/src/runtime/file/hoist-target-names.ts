import { MAX_NAME_LENGTH } from '../../core/limits.ts'

const isObject = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null && !Array.isArray(value)
const listOf = (value: unknown): unknown[] => (Array.isArray(value) ? value : [])

/**
 * Moves blendshape names to `extras.targetNames` of the mesh, where glTF readers expect them. Some exporters write the names to
 * `extras.targetNames` of primitives. Others write them to `extra` or `extras` of morph targets, although glTF allows only vertex attributes
 * there.
 *
 * If a name is empty or too long for a driver, the index of its blendshape replaces it. If several blendshapes have the same name, only the
 * last keeps the name, because three.js finds only the last.
 *
 * @param json JSON of a file, possibly malformed; modified.
 */
export function hoistTargetNames(json: unknown): void {
  for (const mesh of listOf(isObject(json) ? json.meshes : undefined)) {
    if (!isObject(mesh)) continue
    const found = listOf(mesh.primitives).filter(isObject).flatMap(takeNames)
    const extras = isObject(mesh.extras) ? mesh.extras : {}
    const names = Array.isArray(extras.targetNames) ? extras.targetNames : found[0]
    if (names) mesh.extras = { ...extras, targetNames: usableNames(names) }
  }
}

/** Returns the names, with a unique name in place of each name that drivers cannot use. The unique name contains the blendshape's index. */
function usableNames(names: readonly unknown[]): unknown[] {
  const last = new Map(names.map((name, i) => [name, i]))
  const isUsable = (name: unknown, i: number) =>
    typeof name !== 'string' || (name !== '' && name.length <= MAX_NAME_LENGTH && last.get(name) === i)
  const indexName = (i: number) => (last.has(String(i)) ? `blendshape ${i}` : String(i))
  return names.map((name, i) => (isUsable(name, i) ? name : indexName(i)))
}

/** Removes all lists of blendshape names from a primitive. Returns those lists that have a name for each blendshape. */
function takeNames({ targets, extras }: Record<string, unknown>): string[][] {
  const all = listOf(targets).filter(isObject)
  const own = all.map((target) => {
    const name = [target.extra, target.extras].filter(isObject).map(({ targetName }) => targetName)[0]
    // glTF readers would take `extra` for a vertex attribute.
    if (isObject(target.extra)) delete target.extra
    if (isObject(target.extras)) delete target.extras
    return name
  })
  const candidates = [isObject(extras) ? listOf(extras.targetNames) : [], own]
  return candidates.filter(
    (names): names is string[] =>
      names.length === all.length && names.length > 0 && names.every((name) => typeof name === 'string'),
  )
}
