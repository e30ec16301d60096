import type { Node } from '@babylonjs/core/node.js'
import type { Expression } from '../drivers/expression/expression.ts'
import { ExpressionPlayerBase } from '../runtime/expression-player.ts'
import { bindFaceTargets } from './sources/face-targets.ts'
import type { WrinklesBase } from './wrinkles-base.ts'

/**
 * Plays facial expressions. Sets morph targets on all meshes of a face, and activations of its wrinkles. Call `update` once per frame.
 * Between transitions, the player changes nothing, so a page can also move the face with sliders.
 */
export class ExpressionPlayer extends ExpressionPlayerBase {
  /**
   * @param face root node of all meshes of the face: head, eyes, teeth, lashes.
   * @param wrinkles wrinkles of the face. Without them, only morph targets move.
   * @param expressions expressions to play; the first is the initial one. By default, these are all expressions that the face can show:
   *   those in the file, and presets in `EXPRESSIONS`. Unknown names of blendshapes and areas are skipped with one warning.
   * @throws FurrowError if no mesh under `face` has morph targets.
   */
  constructor(face: Node, wrinkles: WrinklesBase | undefined, expressions?: readonly Expression[]) {
    super(wrinkles, (names) => bindFaceTargets(face, names, 'ExpressionPlayer'), expressions)
  }
}
