import type { Input, InputLink } from './activation.ts'
import type { Curve } from './curve.ts'

/** A link in a file: an input of a driver, with a curve and a weight. The result of the link is `weight * curve(input)`. */
export interface Link {
  /** Name of the input, such as the name of a blendshape. */
  name: string
  /** Any number, also negative. */
  weight: number
  /** Curve that is applied to the input. Its outputs can be any numbers. Without a curve, the input is used unchanged. */
  curve?: Curve
}

/** Converts links of a driver in a file to links for evaluation. All inputs have the given kind. */
export function linksTo(kind: 'target' | 'area', links: readonly Link[]): InputLink[] {
  return links.map(({ name, ...link }) => ({ ...link, input: { kind, name } }))
}

/** Creates a single link of weight 1. */
export function linkTo(input: Input): InputLink[] {
  return [{ input, weight: 1 }]
}
