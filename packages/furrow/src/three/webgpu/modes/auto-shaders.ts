import { int, normalMap, texture, varying, vec3, vec4 } from 'three/tsl'
import type { Node } from 'three/webgpu'
import type { ArrayTexture } from '../../material/array-texture.ts'
import type { AutoShaders } from '../../material/auto/auto-shaders.ts'
import { quadMaterial, targetUv } from '../influence/influence-quads.ts'
import type { NodeChannels } from '../mixing/channels.ts'
import type { NodePatch, OwnTexels } from '../mixing/layer-nodes.ts'
import { unpack } from '../mixing/mix-normals.ts'
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
    return quadMaterial('dual', vec4(unitSlope(unpack(texture(base, uv).xyz)), unitSlope(unpack(layer.xyz))))
  },
  valuesMaterial(aoMap, { texture: array, slice }) {
    const uv = varying(targetUv())
    return quadMaterial('values', vec4(texture(aoMap, uv).x, texture(array, uv).depth(int(slice)).xyz))
  },
  dualEdit(material, inputs, { patch, isDual, values }): Added {
    const { normals } = inputs.textures
    const texel = materialProperty('normalMap', 'texture', material).toVar()
    const own: OwnTexels = { normal: unpack(withZ(texel.xy)), isUnit: true }
    const known: KnownTexel[] = [
      {
        texture: normals.texture,
        slice: normals.slices[0]!,
        texel: vec4(withZ(texel.zw), 1),
      },
    ]
    if (values) {
      const occlusion = materialProperty('aoMap', 'texture', material).toVar()
      own.occlusion = occlusion.x
      known.push({ ...values, texel: vec4(occlusion.yzw, 1) })
    }
    return (patch as NodePatch).mix(own, (layers) => ({
      ...layers,
      influence: layers.influence.mul(inputUniform<'float'>(isDual)),
      sampler: (uv) => {
        const sample = layers.sampler(uv)
        return (array, slice) => {
          const found = known.find((other) => other.texture === array && other.slice === slice)
          return found?.texel ?? sample(array, slice)
        }
      },
    }))
  },
}

/** A texel of a layer's map that needs no sample. */
interface KnownTexel {
  texture: ArrayTexture
  slice: number
  texel: Node<'vec4'>
}

/** A normal of unit length as stored, from its x and y as stored. */
function withZ(stored: Node<'vec2'>): Node<'vec3'> {
  const xy = stored.mul(2).sub(1).toVar()
  return vec3(stored, xy.dot(xy).oneMinus().max(1e-6).sqrt().mul(0.5).add(0.5))
}
