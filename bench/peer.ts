/** What the variants of others share: another way to the normal, in GLSL for one renderer and in TSL for the other. */
import { type GrayImage, packColours, type WrinkleSet } from 'furrow'
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
import { mapTexture } from '../packages/furrow/src/three/material/textures.ts'
import type { RendererKind } from './case.ts'
import type { Worn } from './variant.ts'

export interface Peer {
  /** By the names that the shaders use. */
  textures: Record<string, Texture>
  /** Activations in the order of the areas; a uniform of that name. */
  weights: number[]
  /** Declares `vec3 peerNormal(vec3 base, vec2 uv)`; normals -1..1. The weights are `peerWeights`, an array. */
  glsl: string
  /** The same; the weights are nodes of one number each. */
  tsl(
    base: Node<'vec3'>,
    textures: Readonly<Record<string, Texture>>,
    weights: readonly Node<'float'>[],
  ): Node<'vec3'>
}

/** Puts it on a face of its own. */
export function wearPeer(mesh: Mesh, set: WrinkleSet, renderer: RendererKind, peer: Peer): Worn {
  const material = mesh.material as MeshPhysicalMaterial
  if (renderer === 'webgl') patchGlsl(material, peer)
  else patchTsl(material, peer)
  const places = new Map(set.areas.map(({ name }, i) => [name, i]))
  return {
    setActivation(area, value) {
      peer.weights[places.get(area)!] = value
    },
    dispose() {
      for (const own of Object.values(peer.textures)) own.dispose()
    },
  }
}

function patchGlsl(material: MeshPhysicalMaterial, { textures, weights, glsl }: Peer): void {
  const samplers = Object.entries(textures).map(([name, { isDataArrayTexture }]: [string, Kinds]) =>
    isDataArrayTexture ? `uniform highp sampler2DArray ${name};` : `uniform sampler2D ${name};`,
  )
  const declared = `${samplers.join('\n')}\nuniform float peerWeights[${weights.length}];\n${glsl}\n`
  const maps = ShaderChunk.normal_fragment_maps.replace(
    'mapN.xy *= normalScale;',
    'mapN = peerNormal(mapN, vNormalMapUv);\nmapN.xy *= normalScale;',
  )
  material.onBeforeCompile = (shader) => {
    for (const [name, value] of Object.entries(textures)) shader.uniforms[name] = { value }
    shader.uniforms.peerWeights = { value: weights }
    shader.fragmentShader = shader.fragmentShader
      .replace('void main() {', `${declared}void main() {`)
      .replace('#include <normal_fragment_maps>', maps)
  }
  material.customProgramCacheKey = () => declared
}

type Kinds = Texture & { isDataArrayTexture?: true }

function patchTsl(material: MeshPhysicalMaterial, { textures, weights, tsl }: Peer): void {
  const followed = weights.map(
    (_, i) => uniform(0).onObjectUpdate(() => weights[i]) as unknown as Node<'float'>,
  )
  const base = texture(material.normalMap!).xyz.mul(2).sub(1) as Node<'vec3'>
  const normal = tsl(base, textures, followed)
  const scale = uniform(material.normalScale) as unknown as Node<'vec2'>
  // A plain material too: the renderer copies the node to the material that it makes of it.
  Object.assign(material, { normalNode: normalMap(normal.mul(0.5).add(0.5) as Node<'vec3'>, scale) })
}

/** A mask of up to four gray images, one in each channel; channels left over are 0. */
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

/** The layers' normal maps in one array, so that they take one sampler. */
export function normalArray({ layers }: WrinkleSet): DataArrayTexture {
  return mapTexture(packColours(layers.map(({ normal }) => normal)), 1)
}
