import { texture, varying, vec4 } from 'three/tsl'
import type { ComposeMaterial } from '../material/composed-map.ts'
import { influenceFromMap } from './influence.ts'
import { quadMaterial, targetUv } from './influence-quads.ts'
import { mixNormals } from './mix.ts'

/** Draws the composed normal map on `WebGPURenderer`, on WebGPU and on its WebGL 2 backend. */
export const composeMaterial: ComposeMaterial = (base, inputs) => {
  const uv = varying(targetUv())
  const stored = texture(base, uv).xyz
  const mixed = mixNormals(stored, inputs, { influence: influenceFromMap(inputs, uv, null), uv })
  return quadMaterial('composed', vec4(mixed, 1))
}
