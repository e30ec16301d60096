import type { Mesh } from 'three'
import type { ArraySlice, WrinkleSet } from '../../core/types.ts'
import { fadeOnScreen } from '../camera/size-on-screen.ts'
import { checkSource } from '../check-source.ts'
import { FADE } from '../fading/fade.ts'
import type { WrinklesOptions } from '../options.ts'
import { WrinklesBase } from '../wrinkles-base.ts'
import { CHANNELS } from './mixing/channels.ts'
import { OTHER_MODES } from './modes/other-modes.ts'
import { PARTS, WebGLWrinkles } from './webgl-wrinkles.ts'

// A page that makes wrinkles of its own has all modes and maps at once, and what fades.
FADE.value = fadeOnScreen
PARTS.others.value = OTHER_MODES
PARTS.channels.value = CHANNELS

/** Wrinkles on one mesh for `WebGLRenderer`. */
export class Wrinkles extends WrinklesBase {
  /**
   * @param mesh needs UVs and normals and a lit material of its own; each instance of an `InstancedMesh`
   *   or `BatchedMesh` wrinkles independently.
   * @param source a set, copied: later changes to it have no effect, use `addArea`, `removeArea`, `updateArea` and
   *   `updateLayer`. Or the wrinkles of another mesh, which are then shown here too, at rest, from the same textures and by the same
   *   drivers.
   * @throws FurrowError when the mesh, its material or the set does not fit; the mesh is then unchanged.
   */
  constructor(mesh: Mesh, source: WrinkleSet<ArraySlice> | WrinklesBase, options: WrinklesOptions = {}) {
    super(PARTS, mesh, checkSource(source), options)
  }

  /** Those of loaded files too. @internal */
  static override [Symbol.hasInstance](value: unknown): boolean {
    // biome-ignore lint/complexity/noThisInStatic: those of a class that extends it are fewer
    const isOwn = Function.prototype[Symbol.hasInstance].call(this, value)
    // biome-ignore lint/complexity/noThisInStatic: as above
    return isOwn || (this === Wrinkles && value instanceof WebGLWrinkles)
  }
}
