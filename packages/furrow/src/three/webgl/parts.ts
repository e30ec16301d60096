import { MeshBasicMaterial } from 'three'
import type { RendererParts } from '../material/renderer-parts.ts'
import { bindTension } from '../sources/tension.ts'
import { quadMaterials } from './influence/influence-quads.ts'
import { isPatchable } from './mixing/default-shader.ts'
import { composeMaterial } from './modes/compose-material.ts'
import { showDefault } from './modes/default.ts'
import { showInfluence } from './modes/influence-material.ts'
import { showPaper } from './modes/paper.ts'
import { faultOf } from './patch/program-fault.ts'

/** Everything that depends on `WebGLRenderer`. */
export const WEBGL: RendererParts = {
  entry: 'furrow/three',
  canPatch: ({ fragmentShader, isRawShaderMaterial }) =>
    fragmentShader === undefined || (!isRawShaderMaterial && isPatchable(fragmentShader)),
  showDefault,
  showPaper,
  composeMaterial,
  drawsLevels: true,
  showInfluence,
  /**
   * three.js keeps the programs of a material, but the uniforms of the one that it built last: a program that it takes up again, as that of
   * the default mode after `off`, would get none of its own.
   */
  renew(material) {
    material.dispose()
    material.needsUpdate = true
  },
  faultOf,
  unlitMaterial: () => new MeshBasicMaterial({ color: 0, toneMapped: false }),
  bindTension,
  quads: quadMaterials,
  loadRelief: async () => (await import('./relief/relief.ts')).createRelief,
}
