import { MeshBasicNodeMaterial } from 'three/webgpu'
import type { RendererParts } from '../material/renderer-parts.ts'
import { bindComputedTension } from './compute/computed-tension.ts'
import { quadMaterials } from './influence/influence-quads.ts'
import { isCompiling } from './is-compiling.ts'
import { composeMaterial } from './modes/compose-material.ts'
import { showDefault } from './modes/default.ts'
import { showInfluence } from './modes/influence-material.ts'
import { showPaper } from './modes/paper.ts'
import { shaderErrorOf } from './patch/build-error.ts'

export const WEBGPU: RendererParts = {
  entry: 'furrow/webgpu',
  canPatch: () => true,
  showDefault,
  showPaper,
  composeMaterial,
  drawsLevels: false,
  showInfluence,
  renew(material) {
    material.needsUpdate = true
  },
  shaderErrorOf,
  isCompiling,
  unlitMaterial: () => new MeshBasicNodeMaterial({ color: 0, toneMapped: false }),
  bindTension: bindComputedTension,
  quads: quadMaterials,
  loadRelief: async () => (await import('./relief/relief.ts')).createRelief,
}
