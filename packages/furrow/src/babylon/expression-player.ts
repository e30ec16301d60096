import type { Node } from '@babylonjs/core/node.js'
import type { Expression } from '../drivers/expression/expression.ts'
import { ExpressionPlayerBase } from '../runtime/expression-player.ts'
import { bindFaceTargets } from './sources/face-targets.ts'
import type { WrinklesBase } from './wrinkles-base.ts'

/**
 * Plays expressions on a face: sets morph targets on every mesh that has them, and activations of its wrinkles. Call `update` once per
 * frame. The player writes nothing while idle, so sliders can move the face too.
 */
export class ExpressionPlayer extends ExpressionPlayerBase {
  /**
   * @param face root of the moving meshes: head, eyes, teeth, lashes.
   * @param wrinkles wrinkles of the face; undefined to play morph targets only.
   * @param expressions expressions to play, initial one first. Default: those of the file and its VRM, plus the `EXPRESSIONS` that the
   *   face has shapes for (see `expressionNames`). Unknown shape and area names are skipped with one warning.
   * @throws FurrowError if no mesh under `face` has morph targets.
   */
  constructor(face: Node, wrinkles: WrinklesBase | undefined, expressions?: readonly Expression[]) {
    super(wrinkles, (names) => bindFaceTargets(face, names, 'ExpressionPlayer'), expressions)
  }
}
