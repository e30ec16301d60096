import { correctedNames, placeholderName } from '../../shapes/corrections.ts'
import { recogniseShapes } from '../../shapes/recognise.ts'
import type { Skin, SkinTarget } from '../../skin/surface.ts'
import type { TargetHints } from './stand-ins.ts'

/** The recognised targets of a skin. */
export interface KnownTargets {
  /** Their names or corrections; one that means nothing in place of a name that the motion or a correction contradicts. */
  known: readonly string[]
  /** Kind of each target, by motion and name. */
  hints: TargetHints
  /** Middle of the left and right eye, in the coordinates of the skin, where lids close. */
  eyes?: readonly [left: readonly number[], right: readonly number[]] | undefined
}

/** Results by the targets of a skin: choosing a skin and making its wrinkles need the same. */
const found = new WeakMap<readonly SkinTarget[], { skin: Skin; targets: KnownTargets }>()

/**
 * Tells what the targets of a skin are: by their motion, with their names as a hint. The result is kept as long as the arrays of the skin, which
 * nothing may change.
 */
export function knownTargets(skin: Skin): KnownTargets {
  const earlier = found.get(skin.targets)
  if (earlier?.skin.positions === skin.positions && earlier.skin.indices === skin.indices)
    return earlier.targets
  const { shapes, eyes } = recogniseShapes(skin)
  const names = correctedNames(skin.targets)
  const targets: KnownTargets = {
    known: shapes.map(({ isMisnamed }, i) => (isMisnamed ? placeholderName(i) : names[i])),
    hints: shapes.map(({ hint }) => hint),
    eyes,
  }
  found.set(skin.targets, { skin, targets })
  return targets
}
