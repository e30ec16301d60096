import type { Material } from 'three'
import { output, vec4 } from 'three/tsl'
import { patchShader } from '../../packages/furrow/src/three/webgl/patch/patch-shader.ts'
import { replaceChunk } from '../../packages/furrow/src/three/webgl/patch/shader-text.ts'
import type { RendererKind } from '../../stage/stage.ts'

/** Difference between the constants of two programs. It is too small to change an 8-bit pixel. */
const STEP = 1e-8

let count = 0

/**
 * Gives a material a unique shader program, by adding a unique constant to its output colour. Otherwise three.js, the browser or the software
 * rasteriser would reuse a compiled shader. Call this before adding wrinkles, because wrinkles
 * extend the shader that this function has patched.
 */
export function giveDistinctProgram(material: Material, renderer: RendererKind): void {
  const key = `program ${++count}`
  const constant = (count * STEP).toFixed(8)
  if (renderer === 'webgpu') {
    // WebGPURenderer creates a node material from this material and copies `outputNode` to it.
    Object.assign(material, { outputNode: output.add(vec4(Number(constant), 0, 0, 0)) })
    material.customProgramCacheKey = () => key
    return
  }
  patchShader(material, {
    key,
    uniforms: {},
    apply(shader) {
      const add = (chunk: string) => `${chunk}\ngl_FragColor.r += ${constant};`
      shader.fragmentShader = replaceChunk(shader.fragmentShader, 'dithering_fragment', add)
    },
    refuse() {},
  })
}
