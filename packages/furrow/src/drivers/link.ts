import type { Input, InputLink } from './activation.ts'
import type { Curve } from './curve.ts'

/** One input of a driver as files hold it, by name: its value through the curve, if there is one, times the weight. */
export interface Link {
  name: string
  /** Of either sign. */
  weight: number
  curve?: Curve
}

/** Links of a file, each to an input of one kind. */
export function linksTo(kind: 'target' | 'area', links: readonly Link[]): InputLink[] {
  return links.map(({ name, ...link }) => ({ ...link, input: { kind, name } }))
}

/** One link of weight 1. */
export function linkTo(input: Input): InputLink[] {
  return [{ input, weight: 1 }]
}
