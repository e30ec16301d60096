import { MeshBasicMaterial } from 'three'
import type { RendererParts } from '../material/renderer-parts.ts'
import { bindTension } from '../sources/tension.ts'
import { quadMaterials } from './influence/influence-quads.ts'
import { isPatchable } from './mixing/default-shader.ts'
import { composeMaterial } from './modes/compose-material.ts'
import { showDefault } from './modes/default.ts'
import { showInfluence } from './modes/influence-material.ts'
import { showPaper } from './modes/paper.ts'
import { shaderErrorOf } from './patch/program-error.ts'

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
   * Also disposes of the material. three.js caches all programs of a material, but only the uniforms of the program that it built last. Without
   * `dispose` it would reuse a cached program without its uniforms, e.g. in the mode `default` after `off`.
   */
  renew(material) {
    material.dispose()
    material.needsUpdate = true
  },
  shaderErrorOf,
  unlitMaterial: () => new MeshBasicMaterial({ color: 0, toneMapped: false }),
  bindTension,
  quads: quadMaterials,
  loadRelief: async () => (await import('./relief/relief.ts')).createRelief,
}
