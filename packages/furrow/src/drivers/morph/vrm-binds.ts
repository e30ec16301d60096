import { isObject } from '../../core/argument.ts'
import type { Expression } from '../expression/expression.ts'
import { canonicalTargetName, targetFinder } from './target-names.ts'

/** A blendshape that an expression moves, by its index in the file. */
export interface ExpressionBind {
  index: number
  /** Its weight where the expression has weight 1. */
  weight: number
}

/**
 * Which blendshapes of a mesh the expressions of a VRM move: `morphTargetBinds` of VRM 1.0 (`VRMC_vrm`), `blendShapeGroups` of VRM 0
 * (`VRM`).
 *
 * @param json of the file, in which anything may be malformed: that moves nothing.
 * @param mesh index of the mesh in the file.
 * @returns what each moves, by the names that three-vrm gives to expressions: those of VRM 1.0.
 */
export function expressionBinds(json: unknown, mesh: number): Map<string, ExpressionBind[]> {
  const { extensions, nodes } = fieldsOf(json)
  const { VRMC_vrm, VRM } = fieldsOf(extensions)
  const found = new Map<string, ExpressionBind[]>()
  const add = (name: unknown, binds: Fields[], full: number) => {
    // Of several with one name three-vrm takes the first.
    if (typeof name !== 'string' || found.has(name)) return
    found.set(
      name,
      binds.flatMap(({ index, weight }) => {
        const part = Number(weight ?? full) / full
        return Number.isInteger(index) && Number.isFinite(part)
          ? { index: index as number, weight: part }
          : []
      }),
    )
  }
  const { preset, custom } = fieldsOf(fieldsOf(VRMC_vrm).expressions)
  for (const [name, expression] of [preset, custom].flatMap((all) => Object.entries(fieldsOf(all)))) {
    const binds = listOf(fieldsOf(expression).morphTargetBinds)
    const own = binds.filter(({ node }) => fieldsOf(fieldsOf(nodes)[node as number]).mesh === mesh)
    add(name, own, 1)
  }
  if (found.size > 0) return found
  for (const group of listOf(fieldsOf(fieldsOf(VRM).blendShapeMaster).blendShapeGroups)) {
    const own = listOf(group.binds).filter((bind) => bind.mesh === mesh)
    add(PRESETS.get(group.presetName) ?? group.name, own, 100)
  }
  return found
}

/**
 * The expressions of a VRM that move one blendshape of a mesh and no other one, fully.
 *
 * @returns their names by the index of the blendshape.
 */
export function soleExpressions(json: unknown, mesh: number): Map<number, string> {
  const found = new Map<number, string>()
  for (const [name, [bind, ...others]] of expressionBinds(json, mesh))
    if (bind?.weight > 0.99 && others.length === 0 && !found.has(bind.index)) found.set(bind.index, name)
  return found
}

/**
 * The expressions of a VRM that move blendshapes, in the order of the file.
 *
 * @param json of the file, in which anything may be malformed: that moves nothing.
 */
export function vrmExpressions(json: unknown): Expression[] {
  const found = new Map<string, Record<string, number>>()
  for (const [i, mesh] of listOf(fieldsOf(json).meshes).entries()) {
    const names = writtenNames(mesh)
    const find = targetFinder(names)
    for (const [expression, binds] of expressionBinds(json, i)) {
      const targets = found.get(expression) ?? {}
      found.set(expression, targets)
      for (const { index, weight } of binds) {
        const name = names[index]
        if (name === undefined) continue
        const canonical = canonicalTargetName(name)
        const isPlain = find(canonical).join() === String(index)
        targets[isPlain ? canonical : name] = Math.min(1, Math.max(0, weight))
      }
    }
  }
  return [...found].flatMap(([name, targets]) =>
    Object.values(targets).some((weight) => weight > 0) ? [{ name, targets, activations: {} }] : [],
  )
}

/** Names of a mesh's blendshapes, as three.js's loader gives them: their indices where the file has none. */
export function writtenNames(mesh: unknown): string[] {
  const { primitives, extras } = fieldsOf(mesh)
  const { targets } = listOf(primitives)[0] ?? {}
  const count = Array.isArray(targets) ? targets.length : 0
  const names = fieldsOf(extras).targetNames
  const isNamed = Array.isArray(names) && names.length === count
  return Array.from({ length: count }, (_, i) => String(isNamed ? names[i] : i))
}

/** Presets of VRM 0, and the expressions of VRM 1.0 that three-vrm makes of them (`VRMExpressionLoaderPlugin.v0v1PresetNameMap`). */
const PRESETS: ReadonlyMap<unknown, string> = new Map(
  Object.entries({
    a: 'aa',
    i: 'ih',
    u: 'ou',
    e: 'ee',
    o: 'oh',
    blink: 'blink',
    blink_l: 'blinkLeft',
    blink_r: 'blinkRight',
    joy: 'happy',
    angry: 'angry',
    sorrow: 'sad',
    fun: 'relaxed',
    lookup: 'lookUp',
    lookdown: 'lookDown',
    lookleft: 'lookLeft',
    lookright: 'lookRight',
    neutral: 'neutral',
  }),
)

type Fields = Record<string, unknown>

function fieldsOf(value: unknown): Fields {
  return isObject(value) ? (value as Fields) : {}
}

function listOf(value: unknown): Fields[] {
  return Array.isArray(value) ? value.map(fieldsOf) : []
}
