import type { WrinkleSet } from 'furrow'
import { Wrinkles as WebGLWrinkles, type WrinkleMode } from 'furrow/three'
import { Wrinkles as WebGPUWrinkles } from 'furrow/webgpu'
import type { Mesh } from 'three'
import type { RendererKind } from './case.ts'
import type { Worn } from './variant.ts'

/** Furrow's own wrinkles in one of their modes. */
export function wearFurrow(mesh: Mesh, set: WrinkleSet, renderer: RendererKind, mode: WrinkleMode): Worn {
  return renderer === 'webgl'
    ? new WebGLWrinkles(mesh, set, { mode })
    : new WebGPUWrinkles(mesh, set, { mode })
}
