import type { Object3D } from 'three'
import type { Expression } from '../drivers/expression/expression.ts'
import { ExpressionPlayerBase } from '../runtime/expression-player.ts'
import { bindTargets } from './sources/bind-targets.ts'
import type { WrinklesBase } from './wrinkles-base.ts'

/**
 * Plays expressions on a face: sets blendshapes on every mesh that has them, and activations of its wrinkles. Call `update` once per
 * frame. The player writes nothing while idle, so sliders can move the face too.
 */
export class ExpressionPlayer extends ExpressionPlayerBase {
  /**
   * @param face root of the moving meshes: head, eyes, teeth, lashes.
   * @param wrinkles wrinkles of the face; undefined to play blendshapes only.
   * @param expressions expressions to play, initial one first. Default: those of the file and its VRM, plus the `EXPRESSIONS` that the
   *   face has shapes for (see `expressionNames`). Unknown shape and area names are skipped with one warning.
   * @throws FurrowError if no mesh under `face` has morph targets.
   */
  constructor(face: Object3D, wrinkles: WrinklesBase | undefined, expressions?: readonly Expression[]) {
    super(wrinkles, (names) => bindTargets(face, names, 'ExpressionPlayer'), expressions)
  }
}
