import type { Expression } from './expression.ts'
import { EXPRESSIONS } from './presets.ts'

/** Shapes that are whole expressions, by the names of VRM 1.0. */
const WHOLE: readonly Expression[] = ['happy', 'angry', 'sad', 'relaxed', 'surprised'].map((name) => ({
  name,
  targets: { [name]: 1 },
  activations: {},
}))

/** A face, as far as expressions need it. */
export interface ExpressiveFace {
  /** Expressions that its author wrote. */
  authored: readonly Expression[]
  /** Expressions of its VRM. */
  vrm: readonly Expression[]
  /** Selects the names that its blendshapes have, in any spelling that `findTargets` knows. */
  targetsAmong(names: readonly string[]): ReadonlySet<string>
  hasArea(name: string): boolean
}

/**
 * The expressions that a face can show: the author's, its VRM's, shapes that are whole expressions, and those of `EXPRESSIONS` whose
 * shapes it has, unless the author wrote some. Of several with one name the first counts.
 *
 * @returns the initial one first: the author's first, otherwise `neutral`.
 */
export function faceExpressions({ authored, vrm, targetsAmong, hasArea }: ExpressiveFace): Expression[] {
  const [first, ...others] =
    authored.length > 0 ? authored : [vrm.find(({ name }) => name === 'neutral') ?? EXPRESSIONS[0]]
  const presets = authored.length > 0 ? [] : EXPRESSIONS
  const possible = [...others, ...vrm, ...WHOLE, ...presets]
  const present = targetsAmong(possible.flatMap(({ targets }) => Object.keys(targets)))
  const shown = possible.filter((expression, i) => {
    const isOwn = i < others.length
    const moves = canMove(expression, (name) => present.has(name))
    return moves || (isOwn && Object.keys(expression.activations).some(hasArea))
  })
  return uniqueByName([first, ...shown])
}

/** Whether a face has one of the shapes that an expression moves most. */
export function canMove({ targets }: Expression, hasTarget: (name: string) => boolean): boolean {
  const most = Math.max(...Object.values(targets))
  return Object.entries(targets).some(([name, weight]) => weight > 0 && weight === most && hasTarget(name))
}

/** Leaves out expressions whose name an earlier one has. */
export function uniqueByName(expressions: readonly Expression[]): Expression[] {
  const names = new Set<string>()
  return expressions.filter(({ name }) => !names.has(name) && names.add(name))
}
