import type { Input, InputLink } from './activation.ts'
import type { Curve } from './curve.ts'

/** Input of a driver in a file: its value, passed through the optional curve, times the weight. */
export interface Link {
  /** Name of the input, such as a blendshape. */
  name: string
  /** Positive or negative. */
  weight: number
  /** Optional curve from the input to any number. */
  curve?: Curve
}

/** Converts links of a file to links to inputs of one kind. */
export function linksTo(kind: 'target' | 'area', links: readonly Link[]): InputLink[] {
  return links.map(({ name, ...link }) => ({ ...link, input: { kind, name } }))
}

/** Creates a single link of weight 1. */
export function linkTo(input: Input): InputLink[] {
  return [{ input, weight: 1 }]
}
