import { correctedNames, nameless } from '../../shapes/corrections.ts'
import { recogniseShapes } from '../../shapes/recognise.ts'
import type { Skin } from '../../skin/surface.ts'
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

/** Tells what the targets of a skin are: by their motion, with their names as a hint. */
export function knownTargets(skin: Skin): KnownTargets {
  const { shapes, eyes } = recogniseShapes(skin)
  const names = correctedNames(skin.targets)
  return {
    known: shapes.map(({ isMisnamed }, i) => (isMisnamed ? nameless(i) : names[i])),
    hints: shapes.map(({ hint }) => hint),
    eyes,
  }
}
