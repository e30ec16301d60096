import type { Skin } from '../../skin/surface.ts'
import { findBody } from './body.ts'

/** Returns the parts of a humanoid that joints of a skin move, as nouns for messages: for example `left hand`, `neck`, `left elbow` and `waist`. */
export function limbsOf({ skeleton }: Pick<Skin, 'skeleton'>): string[] {
  if (!skeleton) return []
  const { hands, neck, limbs, trunk } = findBody(skeleton)
  return [
    ...hands.map(({ side }) => (side ? `${side} hand` : 'hand')),
    ...(neck ? ['neck'] : []),
    ...limbs.map(({ kind, side }) => (side ? `${side} ${kind}` : kind)),
    ...(trunk ? ['waist'] : []),
  ]
}
