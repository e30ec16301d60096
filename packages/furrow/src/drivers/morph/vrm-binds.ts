import { isObject } from '../../core/argument.ts'
import type { Expression } from '../expression/expression.ts'
import { canonicalTargetName, targetFinder } from './target-names.ts'

/** A blendshape that a VRM expression moves. */
export interface ExpressionBind {
  /** Index of the blendshape in its mesh. */
  index: number
  /** Weight of the blendshape if the expression has weight 1. */
  weight: number
}

/**
 * Reads which blendshapes of a mesh are moved by VRM expressions. VRM 1.0 stores them in `morphTargetBinds` of the extension `VRMC_vrm`,
 * and VRM 0 in `blendShapeGroups` of the extension `VRM`.
 *
 * @param json JSON of the file. Malformed parts are ignored.
 * @param mesh index of the mesh in the file.
 * @returns blendshapes by name of the expression. Names of VRM 0 presets are converted to VRM 1.0, as three-vrm does.
 */
export function expressionBinds(json: unknown, mesh: number): Map<string, ExpressionBind[]> {
  const { extensions, nodes } = fieldsOf(json)
  const { VRMC_vrm, VRM } = fieldsOf(extensions)
  const found = new Map<string, ExpressionBind[]>()
  const add = (name: unknown, binds: Fields[], full: number) => {
    // If several expressions have the same name, three-vrm uses the first.
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

/** Finds VRM expressions that set one blendshape of a mesh to weight 1 and move no other. Returns their names by blendshape index. */
export function soleExpressions(json: unknown, mesh: number): Map<number, string> {
  const found = new Map<number, string>()
  for (const [name, [bind, ...others]] of expressionBinds(json, mesh))
    if (bind?.weight > 0.99 && others.length === 0 && !found.has(bind.index)) found.set(bind.index, name)
  return found
}

/**
 * Reads all VRM expressions that move blendshapes.
 *
 * @param json JSON of the file. Malformed parts are ignored.
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

/** Returns the names of a mesh's blendshapes, as the loader of three.js does. Without names in the file, returns indices as text. */
export function writtenNames(mesh: unknown): string[] {
  const { primitives, extras } = fieldsOf(mesh)
  const { targets } = listOf(primitives)[0] ?? {}
  const count = Array.isArray(targets) ? targets.length : 0
  const names = fieldsOf(extras).targetNames
  const isNamed = Array.isArray(names) && names.length === count
  return Array.from({ length: count }, (_, i) => String(isNamed ? names[i] : i))
}

/** Names of VRM 1.0 expressions by preset of VRM 0, from `VRMExpressionLoaderPlugin.v0v1PresetNameMap` in three-vrm. */
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
