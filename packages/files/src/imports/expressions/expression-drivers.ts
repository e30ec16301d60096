import { EXPRESSIONS, type GrayImage, type WrinkleDriver } from 'furrow'
import type { Skin } from 'furrow/author'
import { repeat, targetFinder } from 'furrow/internal'
import type { SourceExpression } from './read-expressions.ts'

/** Names of expressions in capture sets, with the preset that has the same meaning. */
const PRESET_NAMES: Readonly<Record<string, string>> = {
  surprise: 'surprised',
  anger: 'angry',
  joy: 'happy',
  happiness: 'happy',
  smile: 'happy',
  disgust: 'disgusted',
  sadness: 'sad',
}

/** A blendshape is part of the driver of an area if it moves the area by at least this fraction of what the strongest blendshape does. */
const MIN_MOTION = 0.1

/** How an expression is driven. */
export interface ExpressionInput {
  kind: 'target' | 'targets' | 'input'
  /** Blendshapes that make the expression, with their weights in it. Empty for an input of the application. */
  targets: { name: string; weight: number }[]
}

/**
 * Finds what drives an expression: the blendshapes that the source names, else the blendshape of the same name, else the blendshapes of
 * the preset of the same name. If the face has none of them, the application sets an input of the same name.
 */
export function inputOf({ name, targets }: SourceExpression, names: readonly string[]): ExpressionInput {
  const find = targetFinder(names)
  if (targets) return { kind: 'targets', targets }
  if (find(name).length > 0) return { kind: 'target', targets: [{ name, weight: 1 }] }
  const wanted = PRESET_NAMES[name.toLowerCase()] ?? name.toLowerCase()
  const preset = EXPRESSIONS.find((one) => one.name.toLowerCase() === wanted)
  const known = Object.entries(preset?.targets ?? {}).filter(([target]) => find(target).length > 0)
  if (known.length === 0) return { kind: 'input', targets: [] }
  return { kind: 'targets', targets: known.map(([target, weight]) => ({ name: target, weight })) }
}

/**
 * Creates the driver of an area that shows one key frame of an expression. The activation is 1 at the weight of the key frame, and 0 at the
 * weights of the key frames before and after.
 *
 * @param skin the face, to leave out blendshapes that do not move the area.
 */
export function expressionDriver(
  area: string,
  weights: GrayImage,
  expression: SourceExpression,
  frame: number,
  input: ExpressionInput,
  skin: Skin | undefined,
): WrinkleDriver {
  const curve = frameCurve(expression, frame)
  if (input.kind === 'input') return { type: 'input', name: expression.name, area, curve }
  const moving = skin ? movingTargets(input.targets, weights, skin) : input.targets
  // Least squares: the sum of the links is the weight of the expression if its blendshapes move together.
  const total = moving.reduce((sum, { weight }) => sum + weight * weight, 0)
  const targets = moving.map(({ name, weight }) => ({ name, weight: weight / total }))
  return { type: 'morph', area, targets, rule: 'sum', curve }
}

function frameCurve({ frames }: SourceExpression, frame: number): [number, number][] {
  const { at } = frames[frame]
  const before: [number, number] = [frame === 0 ? 0 : frames[frame - 1].at, 0]
  const after: [number, number][] = frame + 1 < frames.length ? [[frames[frame + 1].at, 0]] : []
  return [before, [at, 1], ...after]
}

function movingTargets(
  targets: ExpressionInput['targets'],
  weights: GrayImage,
  skin: Skin,
): ExpressionInput['targets'] {
  if (targets.length === 1) return targets
  const find = targetFinder(skin.targets.map(({ name }) => name))
  const motions = targets.map(({ name, weight }) => {
    return find(name).reduce(
      (sum, i) => sum + Math.abs(weight) * motionIn(weights, skin, skin.targets[i].offsets),
      0,
    )
  })
  const strongest = Math.max(...motions)
  return strongest > 0 ? targets.filter((_, i) => motions[i] >= MIN_MOTION * strongest) : targets
}

/** Returns the sum of the displacements of all vertices, weighted by the area. */
function motionIn({ width, height, data }: GrayImage, { uvs }: Skin, offsets: ArrayLike<number>): number {
  let sum = 0
  for (let i = 0; i < uvs.length / 2; i++) {
    const column = Math.min(width - 1, Math.floor(repeat(uvs[2 * i]) * width))
    const row = Math.min(height - 1, Math.floor(repeat(uvs[2 * i + 1]) * height))
    const squared = offsets[3 * i] ** 2 + offsets[3 * i + 1] ** 2 + offsets[3 * i + 2] ** 2
    sum += data[row * width + column] * Math.sqrt(squared)
  }
  return sum
}
