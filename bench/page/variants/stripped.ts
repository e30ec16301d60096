import type { GrayImage, Layer, WrinkleSet } from 'furrow'
import {
  DataTexture,
  FloatType,
  LinearFilter,
  type MeshPhysicalMaterial,
  RedFormat,
  type Texture,
} from 'three'
import { float, int, texture, uniform, uv, vec3, vec4 } from 'three/tsl'
import type { Node, NodeMaterial, TextureNode } from 'three/webgpu'
import { valueTextures } from '../../../packages/furrow/src/three/material/value-textures.ts'
import { addValues } from '../../../packages/furrow/src/three/webgl/mixing/add-values.ts'
import {
  BLOOD_COLOUR,
  BLOOD_OF,
  MICRO_SHADOW,
} from '../../../packages/furrow/src/three/webgl/mixing/mix-values.ts'
import { valueLayers } from '../../../packages/furrow/src/three/webgl/mixing/value-layers.ts'
import { MAIN } from '../../../packages/furrow/src/three/webgl/patch/shader-text.ts'
import { shadowHighlights } from '../../../packages/furrow/src/three/webgpu/mixing/micro-shadow.ts'
import { bloodColour, bloodOf } from '../../../packages/furrow/src/three/webgpu/mixing/mix-values.ts'
import { activationOf } from '../../case.ts'
import { applyPeer, normalArray, type Peer } from '../peer.ts'
import type { Variant } from '../variant.ts'

/** Counts that this variant supports. `still` gives every area its activation in frame 0, because the influence map is static. */
const SHOWN = { areas: 8, active: 8, layers: 1, still: true }

/**
 * Lower bound for the default mode's cost per pixel. It samples a static influence map and the layer's maps, and mixes them with the same formula.
 * It omits the other work of the default mode, such as branches, and drawing the influence map every frame.
 */
export const variant: Variant = {
  canShow: ({ areas, layers, maps }) => areas === SHOWN.areas && layers === SHOWN.layers && maps !== 'onset',
  sameAs: 'furrow',
  apply: (mesh, set, renderer, { maps }) => {
    const textures = { strippedWrinkles: normalArray(set), strippedInfluence: influenceTexture(set) }
    const normals = { textures, weights: set.areas.map(() => 0), glsl: NORMALS, tsl }
    return applyPeer(mesh, set, renderer, maps === 'all' ? withValues(normals, set) : normals)
  },
}

/** Computes the influence map of frame 0. Each texel is the sum of the areas' weights times their activations, at most 1. */
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

/** Mixes normals by reoriented normal mapping, as the default mode does. */
const GLSL = /* glsl */ `
vec3 strippedMix(float influence, vec3 base, vec2 uv) {
  vec3 wrinkle = texture(strippedWrinkles, vec3(uv, 0.0)).xyz * 2.0 - 1.0;
  float size = length(base);
  vec3 t = vec3(base.xy, base.z + size);
  vec3 r = vec3(-wrinkle.xy * influence, wrinkle.z);
  return t * dot(t, r) - r * (size * t.z);
}
`

/** Samples the influence map and mixes the normals. Used if the layer has only a normal map. */
const NORMALS = /* glsl */ `${GLSL}
vec3 peerNormal(vec3 base, vec2 uv) {
  return strippedMix(texture(strippedInfluence, uv).r, base, uv);
}
`

const tsl: Peer['tsl'] = (base, { strippedWrinkles, strippedInfluence }) =>
  mixNormal(base, strippedWrinkles, texture(strippedInfluence, uv()).x)

function mixNormal(base: Node<'vec3'>, strippedWrinkles: Texture, influence: Node<'float'>): Node<'vec3'> {
  const wrinkle = texture(strippedWrinkles).depth(int(0)).xyz.mul(2).sub(1)
  const size = base.length().toVar()
  const t = vec3(base.xy, base.z.add(size)).toVar()
  const r = vec3(wrinkle.xy.mul(influence).negate(), wrinkle.z).toVar()
  return t.mul(t.dot(r)).sub(r.mul(size.mul(t.z))) as unknown as Node<'vec3'>
}

/** Adds occlusion and blood. Both are packed in one texel. As in the default mode, occlusion also darkens highlights, and blood tints the skin. */
function withValues(normals: Peer, { layers: [layer] }: WrinkleSet): Peer {
  const values = valueTextures([layer as Layer], 1)
  const { occlusionStrength: strength = 1, bloodAmplitude: amplitude = 0 } = layer
  const { mixOthers } = addValues(valueLayers(values), { isToon: false, normal: '' })
  const textures = { ...normals.textures, strippedValues: values.occlusion!.texture }
  const influence = texture(normals.textures.strippedInfluence, uv()).x.toVar()
  return {
    ...normals,
    textures,
    glsl: /* glsl */ `${GLSL}${MICRO_SHADOW}${BLOOD_OF}
float strippedAt;
vec2 strippedStored;

vec3 peerNormal(vec3 base, vec2 uv) {
  return strippedMix(strippedAt, base, uv);
}

float furrowMix_occlusion(float base) {
  return base + (mix(1.0, strippedStored.x, ${glslFloat(strength)}) - base) * strippedAt;
}

float furrowMix_blood(float base) {
  return furrowBloodOf(strippedStored.y) * ${glslFloat(amplitude)} * strippedAt;
}
${BLOOD_COLOUR}`,
    editGlsl: (fragment) => mixOthers(fragment).replace(MAIN, `${MAIN}${BEGIN}`),
    tsl: (base, { strippedWrinkles }) => mixNormal(base, strippedWrinkles, influence),
    addNodes: (material) =>
      nodesOf(material, influence, texture(textures.strippedValues), strength, amplitude),
  }
}

const BEGIN = /* glsl */ `
  strippedAt = texture(strippedInfluence, vNormalMapUv).r;
  strippedStored = texture(strippedValues, vec3(vNormalMapUv, 0.0)).rg;
  furrowOcclude(furrowMix_occlusion(1.0));`

function glslFloat(value: number): string {
  return value.toFixed(6)
}

function nodesOf(
  material: MeshPhysicalMaterial,
  influence: Node<'float'>,
  values: TextureNode,
  strength: number,
  amplitude: number,
): object {
  const stored = values.depth(int(0)).toVar()
  const visibility = (base: Node<'float'>) =>
    base.add(stored.x.sub(1).mul(strength).add(1).sub(base).mul(influence))
  const map = texture(material.map!)
  const colour = map.rgb.mul(uniform(material.color)) as unknown as Node<'vec3'>
  const occlusion = visibility(texture(material.aoMap!).x)
  return {
    colorNode: vec4(bloodColour(colour, bloodOf(stored.y).mul(amplitude).mul(influence)), map.a),
    aoNode: occlusion.sub(1).mul(material.aoMapIntensity).add(1),
    setupLightingModel(this: NodeMaterial) {
      const model = Object.getPrototypeOf(this).setupLightingModel.call(this)
      return shadowHighlights(model, visibility(float(1)))
    },
  }
}
