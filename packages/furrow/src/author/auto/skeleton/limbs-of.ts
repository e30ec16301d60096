import type { Skin } from '../../skin/surface.ts'
import { findBody } from './body.ts'

/** Returns the parts of a humanoid that joints of a skin move, as nouns for messages: for example `left hand` and `neck`. */
export function limbsOf({ skeleton }: Pick<Skin, 'skeleton'>): string[] {
  if (!skeleton) return []
  const { hands, neck } = findBody(skeleton)
  return [...hands.map(({ side }) => (side ? `${side} hand` : 'hand')), ...(neck ? ['neck'] : [])]
}
