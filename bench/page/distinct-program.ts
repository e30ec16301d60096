import type { Material } from 'three'
import { output, vec4 } from 'three/tsl'
import { patchShader } from '../../packages/furrow/src/three/webgl/patch/patch-shader.ts'
import { replaceChunk } from '../../packages/furrow/src/three/webgl/patch/shader-text.ts'
import type { RendererKind } from '../../stage/stage.ts'

/** What the programs' constants are multiples of: so little that they change no pixel of bytes. */
const STEP = 1e-8

let count = 0

/**
 * Gives a material a program that no other has, by a constant of its own that is added to the colour: neither three.js nor the browser nor the
 * rasteriser can take what they compiled for another. Call it before wrinkles are added: it is then part of the material's own shader,
 * under whatever edits that, and of each program that the material has from then on.
 */
export function giveDistinctProgram(material: Material, renderer: RendererKind): void {
  const key = `program ${++count}`
  const constant = (count * STEP).toFixed(8)
  if (renderer === 'webgpu') {
    // Not a node material: the renderer copies `outputNode` to the node material that it makes of this one.
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
