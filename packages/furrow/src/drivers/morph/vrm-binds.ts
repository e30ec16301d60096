import { isObject } from '../../core/argument.ts'

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
