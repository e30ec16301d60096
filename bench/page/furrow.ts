import type { WrinkleSet } from 'furrow'
import { Wrinkles as WebGLWrinkles, type WrinklesOptions } from 'furrow/three'
import { Wrinkles as WebGPUWrinkles } from 'furrow/webgpu'
import type { Mesh } from 'three'
import { frameOf } from '../../packages/furrow/src/three/frame.ts'
import { quadMaterials as glslQuads } from '../../packages/furrow/src/three/webgl/influence/influence-quads.ts'
import { quadMaterials as tslQuads } from '../../packages/furrow/src/three/webgpu/influence/influence-quads.ts'
import type { RendererKind } from '../../stage/stage.ts'

export function applyFurrow(mesh: Mesh, set: WrinkleSet, renderer: RendererKind, options: WrinklesOptions) {
  return renderer === 'webgl' ? new WebGLWrinkles(mesh, set, options) : new WebGPUWrinkles(mesh, set, options)
}

/**
 * Adds wrinkles as on a page with only one face: their influence map gets a new texture. Otherwise, faces share one texture for their
 * influence maps. The next call of `applyFurrow` uses the new texture too.
 */
export function applyAlone(mesh: Mesh, set: WrinkleSet, renderer: RendererKind, options: WrinklesOptions) {
  const { targets } = frameOf(renderer === 'webgl' ? glslQuads : tslQuads)
  const others = targets.splice(0)
  try {
    return applyFurrow(mesh, set, renderer, options)
  } finally {
    targets.push(...others)
  }
}
