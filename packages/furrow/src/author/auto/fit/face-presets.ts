import type { ExpressionDriver } from '../../../drivers/expression/definition.ts'
import { canMove } from '../../../drivers/expression/face-expressions.ts'
import { EXPRESSIONS } from '../../../drivers/expression/presets.ts'
import { targetFinder } from '../../../drivers/morph/target-names.ts'
import type { DetectedFace } from '../surface/detect-face.ts'

/** Returns the expression presets that a face's blendshapes can show. The presets do not activate areas directly. */
export function facePresets({ names, hints, find }: DetectedFace): ExpressionDriver[] {
  const loaderFinds = targetFinder(names)
  const ownNames = (shape: string) => {
    const found = find(shape)
    const loaded = loaderFinds(shape)
    const isSame = loaded.length > 0 && loaded.every((target) => found.includes(target))
    if (found.length === 0 || isSame) return found.slice(0, 1).map(() => shape)
    // Loaders do not find this shape by its ARKit name, so the preset must name the rig's blendshapes.
    const own = found.filter((target) => hints[target]?.match !== 'like')
    return own.length > 0 ? own.map((target) => names[target]) : [shape]
  }
  const [neutral, ...others] = EXPRESSIONS
  const possible = others.filter((expression) => canMove(expression, (shape) => find(shape).length > 0))
  return [neutral, ...possible].map(({ name, targets }) => {
    const weights = new Map<string, number>()
    for (const [shape, weight] of Object.entries(targets))
      for (const own of ownNames(shape)) weights.set(own, Math.max(weight, weights.get(own) ?? 0))
    return {
      type: 'expression',
      name,
      targets: [...weights].map(([own, weight]) => ({ name: own, weight })),
      activations: [],
    }
  })
}
