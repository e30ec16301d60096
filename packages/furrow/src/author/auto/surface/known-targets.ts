import { correctedNames, placeholderName } from '../../shapes/corrections.ts'
import { recogniseShapes } from '../../shapes/recognise.ts'
import type { Skin, SkinTarget } from '../../skin/surface.ts'
import type { TargetHints } from './stand-ins.ts'

/** Recognised targets of a skin. */
export interface KnownTargets {
  /**
   * Name of each target. If the user assigned an ARKit name to a target, this is the assigned name. A placeholder replaces a name that
   * contradicts the target's motion. It also replaces the name of a target if the user assigned this name to another target.
   */
  known: readonly string[]
  /** Kind of each target, derived from its motion and its name. */
  hints: TargetHints
  /** Centres of the left and right eye, in the coordinates of the skin; undefined if no target closes lids. */
  eyes?: readonly [left: readonly number[], right: readonly number[]] | undefined
}

/** Cache of results, because `chooseSkin` and `detectFace` need them for the same skin. */
const found = new WeakMap<readonly SkinTarget[], { skin: Skin; targets: KnownTargets }>()

/**
 * Recognises the targets of a skin by their motion and their names. The result is cached. The arrays of the skin must not change, because
 * they identify the skin in the cache.
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
