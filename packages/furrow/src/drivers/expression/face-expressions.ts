import type { Expression } from './expression.ts'
import { EXPRESSIONS } from './presets.ts'

/** Blendshapes that are complete expressions, by their names in VRM 1.0. */
const EXPRESSION_SHAPES: readonly Expression[] = ['happy', 'angry', 'sad', 'relaxed', 'surprised'].map(
  (name) => ({
    name,
    targets: { [name]: 1 },
    activations: {},
  }),
)

/** Properties of a face that decide its expressions. */
export interface ExpressiveFace {
  /** Expressions in the file's drivers. */
  authored: readonly Expression[]
  /** Expressions of the VRM. */
  vrm: readonly Expression[]
  /** Selects the names of existing blendshapes, in any spelling that `findTargets` knows. */
  targetsAmong(names: readonly string[]): ReadonlySet<string>
  hasArea(name: string): boolean
}

/**
 * Lists the expressions that a face can show: authored expressions, those of a VRM, and blendshapes that are complete expressions. Without
 * authored expressions, adds the `EXPRESSIONS` whose shapes exist. Duplicate names are skipped.
 *
 * @returns expressions, the initial one first: the first authored one, otherwise `neutral`.
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

/** Whether a face has one of the shapes with the largest weight in an expression. */
export function canMove({ targets }: Expression, hasTarget: (name: string) => boolean): boolean {
  const most = Math.max(...Object.values(targets))
  return Object.entries(targets).some(([name, weight]) => weight > 0 && weight === most && hasTarget(name))
}

/** Removes expressions with duplicate names; keeps the first. */
export function uniqueByName(expressions: readonly Expression[]): Expression[] {
  const names = new Set<string>()
  return expressions.filter(({ name }) => !names.has(name) && names.add(name))
}
