import { correctedNames, placeholderName } from '../../shapes/corrections.ts'
import { recogniseShapes } from '../../shapes/recognise.ts'
import type { Skin, SkinTarget } from '../../skin/surface.ts'
import type { TargetHints } from './stand-ins.ts'

/** Recognised targets of a skin. */
export interface KnownTargets {
  /** Names or corrections of the targets; placeholders for names that the motion or a correction contradicts. */
  known: readonly string[]
  /** Kind of each target, by motion and name. */
  hints: TargetHints
  /** Centres of the left and right eye, in the coordinates of the skin; undefined if no lids close. */
  eyes?: readonly [left: readonly number[], right: readonly number[]] | undefined
}

/** Results by a skin's targets, shared between choosing a skin and making its wrinkles. */
const found = new WeakMap<readonly SkinTarget[], { skin: Skin; targets: KnownTargets }>()

/**
 * Recognises a skin's targets by their motion, with their names as a hint. The result is cached by the arrays of the skin, which must not
 * change.
 */
export function knownTargets(skin: Skin): KnownTargets {
  const cached = found.get(skin.targets)
  if (cached?.skin.positions === skin.positions && cached.skin.indices === skin.indices) return cached.targets
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
