import type { GrayImage, WrinkleSet } from 'furrow'
import { DataTexture, FloatType, LinearFilter, RedFormat } from 'three'
import { int, texture, uv, vec3 } from 'three/tsl'
import type { Node } from 'three/webgpu'
import { activationOf } from '../../case.ts'
import { applyPeer, normalArray } from '../peer.ts'
import type { Variant } from '../variant.ts'

/** The only case that it shows: that of the first frame. */
const SHOWN = { areas: 8, active: 8, layers: 1, still: true, maps: 'normals' }

/**
 * The least that shows the same pixels as the default mode: an influence map that is made once, the layer's map, and the same mix. No
 * areas, no bounds, no fading, no branches. What it costs more than the plain face, no shader with these two samples can save.
 */
export const variant: Variant = {
  canShow: ({ areas, layers, maps }) =>
    areas === SHOWN.areas && layers === SHOWN.layers && maps === 'normals',
  sameAs: 'furrow',
  apply: (mesh, set, renderer) => {
    const textures = { strippedWrinkles: normalArray(set), strippedInfluence: influenceTexture(set) }
    return applyPeer(mesh, set, renderer, { textures, weights: set.areas.map(() => 0), glsl: GLSL, tsl })
  },
}

/** The sum of the areas times their activations in the first frame. */
function influenceTexture({ areas }: WrinkleSet): DataTexture {
  const images = areas.map(({ weights }) => weights as GrayImage)
  const { width, height } = images[0]
  const influence = new Float32Array(width * height)
  for (const [area, { data }] of images.entries()) {
    const activation = activationOf(area, 0, SHOWN)
    for (let i = 0; i < influence.length; i++) influence[i] += (activation * data[i]) / 255
  }
  const map = new DataTexture(
    influence.map((sum) => Math.min(sum, 1)),
    width,
    height,
    RedFormat,
    FloatType,
  )
  map.magFilter = map.minFilter = LinearFilter
  map.needsUpdate = true
  return map
}

/** Reoriented normal mapping as the default mode computes it. */
const GLSL = /* glsl */ `
vec3 peerNormal(vec3 base, vec2 uv) {
  float influence = texture(strippedInfluence, uv).r;
  vec3 wrinkle = texture(strippedWrinkles, vec3(uv, 0.0)).xyz * 2.0 - 1.0;
  float size = length(base);
  vec3 t = vec3(base.xy, base.z + size);
  vec3 r = vec3(-wrinkle.xy * influence, wrinkle.z);
  return t * dot(t, r) - r * (size * t.z);
}`

type Tsl = Parameters<typeof applyPeer>[3]['tsl']

const tsl: Tsl = (base, { strippedWrinkles, strippedInfluence }) => {
  const influence = texture(strippedInfluence, uv()).x
  const wrinkle = texture(strippedWrinkles).depth(int(0)).xyz.mul(2).sub(1)
  const size = base.length().toVar()
  const t = vec3(base.xy, base.z.add(size)).toVar()
  const r = vec3(wrinkle.xy.mul(influence).negate(), wrinkle.z).toVar()
  return t.mul(t.dot(r)).sub(r.mul(size.mul(t.z))) as unknown as Node<'vec3'>
}
