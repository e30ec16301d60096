import type { Object3D } from 'three'
import type { Expression } from '../drivers/expression/expression.ts'
import { ExpressionPlayerBase } from '../runtime/expression-player.ts'
import { bindTargets } from './sources/bind-targets.ts'
import type { WrinklesBase } from './wrinkles-base.ts'

/**
 * Plays expressions on a face: blendshapes on every mesh that has them, and activations on its wrinkles.
 * Call `update` once per frame; while nothing is playing it writes nothing, so sliders may move the face too.
 */
export class ExpressionPlayer extends ExpressionPlayerBase {
  /**
   * @param face any object above the meshes that move: head, eyes, teeth, lashes.
   * @param expressions the first is the initial one; by default those of the file, or `EXPRESSIONS` where it has none.
   * @throws FurrowError when nothing under `face` has morph targets. Names of an expression that no mesh and no
   *   area has are left out with one warning.
   */
  constructor(face: Object3D, wrinkles: WrinklesBase, expressions?: readonly Expression[]) {
    super(wrinkles, (names) => bindTargets(face, names, 'ExpressionPlayer'), expressions)
  }
}
