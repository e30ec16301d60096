import type { Material } from 'three'
import { output, vec4 } from 'three/tsl'
import { patchShader } from '../../packages/furrow/src/three/webgl/patch/patch-shader.ts'
import { replaceChunk } from '../../packages/furrow/src/three/webgl/patch/shader-text.ts'
import type { RendererKind } from '../../stage/stage.ts'

/** Step of the constants, too small to change an 8-bit pixel. */
const STEP = 1e-8

let count = 0

/**
 * Gives a material a unique program by adding a unique constant to the colour, so that three.js, the browser and the rasteriser cannot
 * reuse a compiled shader. Call before adding wrinkles, which then extend the patched shader.
 */
export function giveDistinctProgram(material: Material, renderer: RendererKind): void {
  const key = `program ${++count}`
  const constant = (count * STEP).toFixed(8)
  if (renderer === 'webgpu') {
    // The renderer copies `outputNode` to the node material it creates from this material.
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
