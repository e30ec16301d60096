import type { GrayImage } from 'furrow'
import { int, mix, texture, uv, vec4 } from 'three/tsl'
import type { Node } from 'three/webgpu'
import { applyPeer, maskTexture, normalArray, type Peer } from '../peer.ts'
import type { Variant } from '../variant.ts'

/** Samplers that are free for masks. WebGL and WebGPU guarantee 16, the material uses 7, and the layers' normal maps use 1. */
const MAX_MASKS = 8

/**
 * The technique of Open 3D Engine's skin material (`Skin_Common.azsli`, `WrinkleMask.azsli`). Each area has a mask whose four channels are the
 * weights of four layers. The shader sums the masks times the activations. It then mixes each layer's normal into the result, in the layers' order.
 */
export const variant: Variant = {
  canShow: ({ areas, maps }) => areas <= MAX_MASKS && maps === 'normals',
  apply: (mesh, set, renderer) => {
    const names = set.layers.map(({ name }) => name)
    const masks = set.areas.map(({ layer, weights }) => {
      const channel = names.indexOf(layer!)
      return maskTexture([0, 1, 2, 3].map((i) => (i === channel ? (weights as GrayImage) : undefined)))
    })
    const textures = {
      peerWrinkles: normalArray(set),
      ...Object.fromEntries(masks.map((mask, i) => [`peerMask${i}`, mask])),
    }
    const weights = masks.map(() => 0)
    return applyPeer(mesh, set, renderer, {
      textures,
      weights,
      glsl: glslOf(masks.length, names.length),
      tsl: tslOf(masks.length, names.length),
    })
  },
}

/** Returns the GLSL code. The loop over the masks is unrolled, because GLSL cannot index samplers by a loop counter. */
function glslOf(masks: number, layers: number): string {
  const added = Array.from(
    { length: masks },
    (_, i) => `layerWeights += texture(peerMask${i}, uv) * peerWeights[${i}];`,
  )
  const mixed = Array.from({ length: layers }, (_, i) => {
    const normal = `texture(peerWrinkles, vec3(uv, ${i}.0)).xyz * 2.0 - 1.0`
    return `normal = mix(normal, ${normal}, layerWeights[${i}]);`
  })
  return /* glsl */ `
vec3 peerNormal(vec3 base, vec2 uv) {
  vec4 layerWeights = vec4(0.0);
  ${added.join('\n  ')}
  layerWeights = min(layerWeights, 1.0);
  vec3 normal = base;
  ${mixed.join('\n  ')}
  return normalize(normal);
}`
}

function tslOf(masks: number, layers: number): Peer['tsl'] {
  return (base, textures, weights) => {
    const coordinates = uv().toVar()
    const parts = Array.from({ length: masks }, (_, i) =>
      texture(textures[`peerMask${i}`], coordinates).mul(weights[i]),
    )
    const sum = parts.reduce<Node<'vec4'>>((total, part) => total.add(part) as Node<'vec4'>, vec4(0))
    const layerWeights = sum.min(1).toVar()
    const channels = [layerWeights.x, layerWeights.y, layerWeights.z, layerWeights.w]
    const mixed = Array.from({ length: layers }).reduce<Node<'vec3'>>((normal, _, i) => {
      const layerNormal = texture(textures.peerWrinkles, coordinates)
        .depth(int(i))
        .xyz.mul(2)
        .sub(1) as Node<'vec3'>
      return mix(normal, layerNormal, channels[i]) as Node<'vec3'>
    }, base)
    return mixed.normalize() as Node<'vec3'>
  }
}
