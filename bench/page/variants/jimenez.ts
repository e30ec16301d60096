import type { GrayImage } from 'furrow'
import { dot, int, texture, uv, vec3, vec4 } from 'three/tsl'
import type { Node } from 'three/webgpu'
import { applyPeer, maskTexture, normalArray } from '../peer.ts'
import type { Variant } from '../variant.ts'

/**
 * The technique of Jimenez, Echevarria, Oat, Gutierrez: "Practical and Realistic Facial Wrinkles Animation", GPU Pro 2 (2011). It has one wrinkle
 * map and eight zones in the channels of two masks: `normal.xy += wrinkles.xy * sum(mask[i] * weight[i])`.
 */
export const variant: Variant = {
  canShow: ({ areas, layers, maps }) => areas === 8 && layers === 1 && maps === 'normals',
  apply: (mesh, set, renderer) => {
    const weights = set.areas.map(({ weights }) => weights as GrayImage)
    const textures = {
      peerWrinkles: normalArray(set),
      peerMask0: maskTexture(weights.slice(0, 4)),
      peerMask1: maskTexture(weights.slice(4)),
    }
    return applyPeer(mesh, set, renderer, { textures, weights: weights.map(() => 0), glsl: GLSL, tsl })
  },
}

const GLSL = /* glsl */ `
vec3 peerNormal(vec3 base, vec2 uv) {
  vec2 wrinkles = texture(peerWrinkles, vec3(uv, 0.0)).xy * 2.0 - 1.0;
  vec4 first = texture(peerMask0, uv) * vec4(peerWeights[0], peerWeights[1], peerWeights[2], peerWeights[3]);
  vec4 second = texture(peerMask1, uv) * vec4(peerWeights[4], peerWeights[5], peerWeights[6], peerWeights[7]);
  return normalize(vec3(base.xy + wrinkles * dot(first + second, vec4(1.0)), base.z));
}`

type Tsl = Parameters<typeof applyPeer>[3]['tsl']

const tsl: Tsl = (base, { peerWrinkles, peerMask0, peerMask1 }, [a, b, c, d, e, f, g, h]) => {
  const wrinkles = texture(peerWrinkles).depth(int(0)).xy.mul(2).sub(1)
  const first = texture(peerMask0, uv()).mul(vec4(a, b, c, d))
  const second = texture(peerMask1, uv()).mul(vec4(e, f, g, h))
  const sum = dot(first.add(second) as Node<'vec4'>, vec4(1))
  return vec3(base.xy.add(wrinkles.mul(sum)), base.z).normalize() as unknown as Node<'vec3'>
}
