import type { Input, InputLink } from './activation.ts'
import type { Curve } from './curve.ts'

/** One input of a driver in a file: its value, passed through the curve if there is one, times the weight. */
export interface Link {
  /** Name of the input, such as a blendshape. */
  name: string
  /** Positive or negative. */
  weight: number
  /** From the input to any number; none by default. */
  curve?: Curve
}

/** Links of a file, as links to inputs of one kind. */
export function linksTo(kind: 'target' | 'area', links: readonly Link[]): InputLink[] {
  return links.map(({ name, ...link }) => ({ ...link, input: { kind, name } }))
}

/** A single link of weight 1. */
export function linkTo(input: Input): InputLink[] {
  return [{ input, weight: 1 }]
}
