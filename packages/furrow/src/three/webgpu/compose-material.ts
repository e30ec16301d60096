import { select, texture, varying, vec4 } from 'three/tsl'
import type { ComposeMaterial } from '../material/composed-map.ts'
import { influenceFromMap } from './influence.ts'
import { quadMaterial, targetUv } from './influence-quads.ts'
import { mixNormals } from './mix.ts'
import { texelAt } from './texture-sampling.ts'

/** Draws the composed normal map on `WebGPURenderer`, on WebGPU and on its WebGL 2 backend. */
export const composeMaterial: ComposeMaterial = (base, inputs, level) => {
  const isTexelwise = level !== undefined
  const uv = varying(targetUv())
  const own = texture(base, uv)
  const stored = (isTexelwise ? own.load(texelAt(own, uv)) : own).xyz
  const influence = influenceFromMap(inputs, uv, null)
  const mixed = mixNormals(stored, inputs, {
    influence,
    uv,
    sampling: isTexelwise ? 'texels' : 'sampler',
  }).toVar()
  if (!inputs.textures.kinds.includes('detail')) return quadMaterial('composed', vec4(mixed, 1))
  const unit = mixed.mul(2).sub(1).normalize().mul(0.5).add(0.5)
  return quadMaterial('composed', vec4(select(influence.greaterThan(vec4(0)).any(), unit, mixed), 1))
}
