import { int, mix, normalMap, texture, varying, vec2, vec3, vec4 } from 'three/tsl'
import type { Node } from 'three/webgpu'
import type { AutoShaders } from '../../material/auto/auto-shaders.ts'
import { quadMaterial, targetUv } from '../influence/influence-quads.ts'
import type { NodeChannels } from '../mixing/channels.ts'
import type { NodePatch } from '../mixing/layer-nodes.ts'
import { inputUniform, materialProperty, normalScale } from '../node.ts'
import type { Added } from '../patch/patch-nodes.ts'
import { occlusionMaterial, unitSlope } from './compose-material.ts'

/** What the mode `auto` takes on `WebGPURenderer`. */
export const AUTO_SHADERS: Omit<AutoShaders, 'composeMaterial'> = {
  occlusionMaterial,
  composedEdit(material, inputs, { channels }): Added {
    const texel = materialProperty('normalMap', 'texture', material).toVar()
    const added: Added = { normalNode: normalMap(withZ(texel.xy), normalScale(material)) }
    ;(channels as NodeChannels).addStored(added, material, inputs, texel.zw)
    return added
  },
  dualMaterial(base, { normals }) {
    const uv = varying(targetUv())
    const layer = texture(normals.texture, uv).depth(int(normals.slices[0]!))
    return quadMaterial('dual', vec4(unitSlope(texture(base, uv).xyz), unitSlope(layer.xyz)))
  },
  dualEdit(material, inputs, { patch, isDual }): Added {
    const { normals, kinds } = inputs.textures
    const texel = materialProperty('normalMap', 'texture', material).toVar()
    // Of another map than a dual one, the layer changes nothing.
    const none = kinds[0] === 'replace' ? texel.xy : vec2(0.5)
    const first = mix(none, texel.zw, inputUniform<'float'>(isDual))
    return (patch as NodePatch).mix({ stored: withZ(texel.xy) }, (sampler) => (uv) => {
      const sample = sampler(uv)
      return (array, slice) =>
        array === normals.texture && slice === normals.slices[0]
          ? vec4(withZ(first), 1)
          : sample(array, slice)
    })
  },
}

/** A normal of unit length as stored, from its x and y as stored. */
function withZ(stored: Node<'vec2'>): Node<'vec3'> {
  const xy = stored.mul(2).sub(1).toVar()
  return vec3(stored, xy.dot(xy).oneMinus().max(0).sqrt().mul(0.5).add(0.5))
}
