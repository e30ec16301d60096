import type { Expression } from './expression.ts'
import { EXPRESSIONS } from './presets.ts'

/** Expressions for faces whose blendshapes are named like VRM 1.0 expressions. Each moves the blendshape of the same name. */
const EXPRESSION_SHAPES: readonly Expression[] = ['happy', 'angry', 'sad', 'relaxed', 'surprised'].map(
  (name) => ({
    name,
    targets: { [name]: 1 },
    activations: {},
  }),
)

/** Properties of a face that decide which expressions it can show. */
export interface ExpressiveFace {
  /** Expressions stored as drivers in the file. */
  authored: readonly Expression[]
  /** Expressions of a VRM avatar. */
  vrm: readonly Expression[]
  /** Returns those names that match a blendshape of the face, in any spelling that `findTargets` knows. */
  targetsAmong(names: readonly string[]): ReadonlySet<string>
  hasArea(name: string): boolean
}

/**
 * Lists the expressions that a face can show: authored expressions, expressions of a VRM avatar, and blendshapes named like VRM
 * expressions. If the file has no authored expressions, adds the presets in `EXPRESSIONS` that the face can show. Of several expressions
 * with the same name, the first is kept.
 *
 * @returns expressions. The initial one comes first: the first authored expression, or `neutral` if there is none.
 */
export function faceExpressions({ authored, vrm, targetsAmong, hasArea }: ExpressiveFace): Expression[] {
  const [first, ...others] =
    authored.length > 0 ? authored : [vrm.find(({ name }) => name === 'neutral') ?? EXPRESSIONS[0]]
  const presets = authored.length > 0 ? [] : EXPRESSIONS
  const possible = [...others, ...vrm, ...EXPRESSION_SHAPES, ...presets]
  const present = targetsAmong(possible.flatMap(({ targets }) => Object.keys(targets)))
  const shown = possible.filter((expression, i) => {
    const isOwn = i < others.length
    const moves = canMove(expression, (name) => present.has(name))
    return moves || (isOwn && Object.keys(expression.activations).some(hasArea))
  })
  return uniqueByName([first, ...shown])
}

/** Whether a face has the blendshape with the largest weight in an expression. If several share this weight, one of them is enough. */
export function canMove({ targets }: Expression, hasTarget: (name: string) => boolean): boolean {
  const most = Math.max(...Object.values(targets))
  return Object.entries(targets).some(([name, weight]) => weight > 0 && weight === most && hasTarget(name))
}

/** Removes expressions with duplicate names. Keeps the first expression of each name. */
export function uniqueByName(expressions: readonly Expression[]): Expression[] {
  const names = new Set<string>()
  return expressions.filter(({ name }) => !names.has(name) && names.add(name))
}
