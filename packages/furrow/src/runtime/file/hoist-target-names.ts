import { LONGEST_NAME } from '../../core/limits.ts'

const isObject = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null && !Array.isArray(value)
const listOf = (value: unknown): unknown[] => (Array.isArray(value) ? value : [])

/**
 * Moves names of blendshapes to `extras.targetNames` of their mesh, where glTF's readers look for them. Some exporters write them to
 * `extras.targetNames` of primitives, or to `targets[].extra.targetName`, which glTF forbids. Empty names, names that are too long for a
 * driver, and those that a later blendshape has too become the index of their blendshape: three.js finds the last one by its name.
 *
 * @param json of a file, in which anything may be malformed; it is changed.
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

/** Names that a driver can use; an index stays unique. */
function usableNames(names: readonly unknown[]): unknown[] {
  const last = new Map(names.map((name, i) => [name, i]))
  const isUsable = (name: unknown, i: number) =>
    typeof name !== 'string' || (name !== '' && name.length <= LONGEST_NAME && last.get(name) === i)
  const indexName = (i: number) => (last.has(String(i)) ? `blendshape ${i}` : String(i))
  return names.map((name, i) => (isUsable(name, i) ? name : indexName(i)))
}

/** The names that a primitive has; nothing where some of its blendshapes have none. */
function takeNames({ targets, extras }: Record<string, unknown>): string[][] {
  const all = listOf(targets).filter(isObject)
  const own = all.map((target) => {
    const name = [target.extra, target.extras].filter(isObject).map(({ targetName }) => targetName)[0]
    // Not an attribute, as everything else in a target is.
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
