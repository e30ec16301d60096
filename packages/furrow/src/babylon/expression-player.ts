import type { Node } from '@babylonjs/core/node.js'
import type { Expression } from '../drivers/expression/expression.ts'
import { ExpressionPlayerBase } from '../runtime/expression-player.ts'
import { bindFaceTargets } from './sources/face-targets.ts'
import type { WrinklesBase } from './wrinkles-base.ts'

/**
 * Plays expressions on a face: morph targets on every mesh that has them, and activations on its wrinkles. Call `update` once per
 * frame; while nothing is playing it writes nothing, so that sliders can move the face too.
 */
export class ExpressionPlayer extends ExpressionPlayerBase {
  /**
   * @param face the root of the meshes that move: head, eyes, teeth, lashes.
   * @param wrinkles of the face; undefined for a face without, which then only moves.
   * @param expressions the first is the initial one; by default those of the file and its VRM, and of `EXPRESSIONS` those for which it
   *   has shapes: see `expressionNames`. Names that no mesh or area has are left out with one warning.
   * @throws FurrowError when no mesh under `face` has morph targets.
   */
  constructor(face: Node, wrinkles: WrinklesBase | undefined, expressions?: readonly Expression[]) {
    super(wrinkles, (names) => bindFaceTargets(face, names, 'ExpressionPlayer'), expressions)
  }
}
