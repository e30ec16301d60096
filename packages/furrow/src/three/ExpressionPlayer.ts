import type { Object3D } from 'three'
import type { Expression } from '../drivers/expression/expression.ts'
import { ExpressionPlayerBase } from '../runtime/expression-player.ts'
import { bindTargets } from './sources/bind-targets.ts'
import type { WrinklesBase } from './wrinkles-base.ts'

/**
 * Plays expressions on a face: sets the blendshape weights of its meshes and the activations of its wrinkles. Call `update` once per frame.
 * Between transitions the player sets nothing, so other code can set the weights too.
 */
export class ExpressionPlayer extends ExpressionPlayerBase {
  /**
   * @param face root of the moving meshes: head, eyes, teeth, lashes.
   * @param wrinkles wrinkles of the face; undefined to play blendshapes only.
   * @param expressions expressions to play, the initial expression first. Default: the expressions in the file's drivers and in its VRM data.
   *   If the drivers contain no expressions, the presets from `EXPRESSIONS` whose blendshapes exist on the face are added. Unknown
   *   blendshapes and areas are skipped with one warning.
   * @throws FurrowError if no mesh under `face` has morph targets.
   */
  constructor(face: Object3D, wrinkles: WrinklesBase | undefined, expressions?: readonly Expression[]) {
    super(wrinkles, (names) => bindTargets(face, names, 'ExpressionPlayer'), expressions)
  }
}
