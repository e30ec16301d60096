import type { WrinkleSet } from 'furrow'
import { Wrinkles as WebGLWrinkles, type WrinklesOptions } from 'furrow/three'
import { Wrinkles as WebGPUWrinkles } from 'furrow/webgpu'
import type { Mesh } from 'three'
import type { RendererKind } from '../../stage/stage.ts'

/** Adds Furrow's wrinkles to a mesh. */
export function applyFurrow(mesh: Mesh, set: WrinkleSet, renderer: RendererKind, options: WrinklesOptions) {
  return renderer === 'webgl' ? new WebGLWrinkles(mesh, set, options) : new WebGPUWrinkles(mesh, set, options)
}
