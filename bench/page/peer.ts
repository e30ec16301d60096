/** Code shared by the variants `jimenez`, `o3de` and `stripped`. They compute the normal in GLSL for WebGL and in TSL for WebGPU. */
import type { GrayImage, WrinkleSet } from 'furrow'
import { packColours } from 'furrow/internal'
import {
  type DataArrayTexture,
  DataTexture,
  LinearFilter,
  type Mesh,
  type MeshPhysicalMaterial,
  ShaderChunk,
  type Texture,
} from 'three'
import { normalMap, texture, uniform } from 'three/tsl'
import type { Node } from 'three/webgpu'
import { mapTexture } from '../../packages/furrow/src/three/material/textures.ts'
import { patchShader } from '../../packages/furrow/src/three/webgl/patch/patch-shader.ts'
import type { RendererKind } from '../../stage/stage.ts'
import type { AppliedVariant } from './variant.ts'

/** Textures and shader code of one technique. */
export interface Peer {
  /** Textures by their name in GLSL. */
  textures: Record<string, Texture>
  /** Activations of the areas, in the order of the wrinkle set. The shaders read them every frame. */
  weights: number[]
  /**
   * GLSL code that defines `vec3 peerNormal(vec3 base, vec2 uv)`. `base` is the texel of the face's normal map, and the function returns the
   * normal with wrinkles, both in -1..1. The code reads `weights` from the uniform array `peerWeights`.
   */
  glsl: string
  editGlsl?: (fragment: string) => string
  /** Computes the same normal as `glsl`, in TSL. */
  tsl(
    base: Node<'vec3'>,
    textures: Readonly<Record<string, Texture>>,
    weights: readonly Node<'float'>[],
  ): Node<'vec3'>
  /** Returns further nodes to assign to the material. */
  addNodes?: (material: MeshPhysicalMaterial) => object
}

export function applyPeer(mesh: Mesh, set: WrinkleSet, renderer: RendererKind, peer: Peer): AppliedVariant {
  const material = mesh.material as MeshPhysicalMaterial
  if (renderer === 'webgl') patchGlsl(material, peer)
  else patchTsl(material, peer)
  const indices = new Map(set.areas.map(({ name }, i) => [name, i]))
  return {
    setActivation(area, value) {
      peer.weights[indices.get(area)!] = value
    },
    dispose() {
      for (const map of Object.values(peer.textures)) map.dispose()
    },
  }
}

function patchGlsl(
  material: MeshPhysicalMaterial,
  { textures, weights, glsl, editGlsl = (fragment) => fragment }: Peer,
): void {
  const samplers = Object.entries(textures).map(
    ([name, { isDataArrayTexture }]: [string, MaybeArrayTexture]) =>
      isDataArrayTexture ? `uniform highp sampler2DArray ${name};` : `uniform sampler2D ${name};`,
  )
  const declarations = `${samplers.join('\n')}\nuniform float peerWeights[${weights.length}];\n${glsl}\n`
  const maps = ShaderChunk.normal_fragment_maps.replace(
    'mapN.xy *= normalScale;',
    'mapN = peerNormal(mapN, vNormalMapUv);\nmapN.xy *= normalScale;',
  )
  patchShader(material, {
    key: declarations,
    uniforms: {
      ...Object.fromEntries(Object.entries(textures).map(([name, value]) => [name, { value }])),
      peerWeights: { value: weights },
    },
    apply(shader) {
      const shown = shader.fragmentShader.replace('#include <normal_fragment_maps>', maps)
      shader.fragmentShader = editGlsl(shown).replace('void main() {', `${declarations}void main() {`)
    },
    refuse() {},
  })
}

type MaybeArrayTexture = Texture & { isDataArrayTexture?: true }

function patchTsl(material: MeshPhysicalMaterial, { textures, weights, tsl, addNodes }: Peer): void {
  const weightNodes = weights.map(
    (_, i) => uniform(0).onObjectUpdate(() => weights[i]) as unknown as Node<'float'>,
  )
  const base = texture(material.normalMap!).xyz.mul(2).sub(1) as Node<'vec3'>
  const normal = tsl(base, textures, weightNodes)
  const scale = uniform(material.normalScale) as unknown as Node<'vec2'>
  // WebGPURenderer creates a node material from this material and copies `normalNode` to it. Its program cache ignores the copied nodes. Each
  // technique needs its own cache key, or it would use the program of another technique.
  Object.assign(material, addNodes?.(material), {
    normalNode: normalMap(normal.mul(0.5).add(0.5) as Node<'vec3'>, scale),
  })
  const name = `${material.customProgramCacheKey()} ${Object.keys(textures).join(' ')}`
  material.customProgramCacheKey = () => name
}

/** Packs up to four gray images into the channels of an RGBA texture. Unused channels are 0. */
export function maskTexture(images: readonly (GrayImage | undefined)[]): DataTexture {
  const { width, height } = images.find((image) => image)!
  const data = new Uint8Array(4 * width * height)
  for (const [channel, image] of images.entries()) {
    image?.data.forEach((weight, i) => {
      data[4 * i + channel] = weight
    })
  }
  const mask = new DataTexture(data, width, height)
  mask.magFilter = mask.minFilter = LinearFilter
  mask.needsUpdate = true
  return mask
}

/** Packs the layers' normal maps into one array texture, because the number of samplers is limited. */
export function normalArray({ layers }: WrinkleSet): DataArrayTexture {
  return mapTexture(packColours(layers.map(({ normal }) => normal)), 1)
}
