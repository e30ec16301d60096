import type { Mesh, MeshStandardMaterial } from 'three'
import {
  cameraViewMatrix,
  int,
  Loop,
  materialReference,
  normalMap,
  normalView,
  normalWorld,
  select,
  sRGBTransferEOTF,
  subBuild,
  texture,
  vec3,
  vec4,
} from 'three/tsl'
import type { MeshStandardNodeMaterial, Node, NodeBuilder, NodeMaterial } from 'three/webgpu'
import type { ArraySlice, WrinkleSet } from '../../core/types.ts'
import type { PaperArray } from '../material/paper-array.ts'
import type { RendererParts } from '../material/renderer-parts.ts'
import type { ShaderInputs } from '../material/shader-inputs.ts'
import type { WrinkleMaterial } from '../material/wrinkle-material.ts'
import type { WrinklesOptions } from '../options.ts'
import { WrinklesBase } from '../wrinkles-base.ts'
import { composeMaterial } from './compose-material.ts'
import { influenceFromAreas, influenceFromMap, mapUv, repeat } from './influence.ts'
import { influenceMaterial } from './influence-material.ts'
import { quadMaterials } from './influence-quads.ts'
import { mixNormals, mixValues, type Shares } from './mix.ts'

/** Wrinkles on one mesh for `WebGPURenderer`, on WebGPU and on its WebGL 2 backend. */
export class Wrinkles extends WrinklesBase {
  /**
   * @param mesh needs UVs and normals and a material of its own that is lit: a node material or a plain one; each
   *   instance of an `InstancedMesh` or `BatchedMesh` wrinkles by itself.
   * @param source a set, copied: later changes to it are not seen, use `addArea` and `removeArea`. Or the wrinkles
   *   of another mesh, which are then shown here too, at rest, from the same textures.
   * @throws FurrowError when the mesh, its material or the set does not fit; the mesh is then untouched.
   */
  constructor(mesh: Mesh, source: WrinkleSet<ArraySlice> | WrinklesBase, options: WrinklesOptions = {}) {
    super({ patch, influenceMaterial, composeMaterial, quads: quadMaterials }, mesh, source, options)
  }
}

const PATCHED = [
  'normalNode',
  'colorNode',
  'roughnessNode',
  'aoNode',
  'setupLighting',
  'customProgramCacheKey',
] as const

/** What the patch sets; plain materials carry these too, the renderer copies them to the nodes it makes. */
type Patched = WrinkleMaterial &
  Partial<Pick<MeshStandardNodeMaterial, Exclude<(typeof PATCHED)[number], 'customProgramCacheKey'>>>

let patches = 0

const patch: RendererParts['patch'] = (material: Patched, inputs, mode, instances) => {
  const own = Object.fromEntries(
    PATCHED.filter((key) => Object.hasOwn(material, key)).map((key) => [key, material[key]]),
  )
  const place = mapUv(material)
  const added =
    mode === 'paper'
      ? paper(inputs.paper!, place, influenceFromAreas(inputs, inputs.paper!.table, place))
      : layers(material, inputs, { influence: influenceFromMap(inputs, place, instances), uv: place })
  Object.assign(material, added)
  // The renderer shares one built program among plain materials with equal properties, and nodes are not
  // among those it compares; these read textures of their own.
  const variant = `furrow ${mode} ${patches++}`
  const cacheKey = material.customProgramCacheKey
  material.customProgramCacheKey = () => `${cacheKey.call(material)} ${variant}`
  return () => {
    for (const key of [...Object.keys(added), 'customProgramCacheKey']) {
      delete (material as unknown as Record<string, unknown>)[key]
    }
    Object.assign(material, own)
  }
}

/** The default mode: the layers' maps mixed into the material's, lit once. */
function layers(material: Patched, inputs: ShaderInputs, shares: Shares): Partial<Patched> {
  const base = reference<'vec4'>('normalMap', 'texture')
  const mixed = mixNormals(base.xyz as Node<'vec3'>, inputs, shares)
  const added: Partial<Patched> = { normalNode: normalMap(mixed, scale()) }
  const { baseColor, roughness, occlusion } = inputs.textures.values
  const { map, roughnessMap, aoMap } = material as Partial<MeshStandardMaterial>
  const white = vec3(1) as unknown as Node<'vec3'>
  if (baseColor) {
    const own = map ? reference<'vec4'>('map', 'texture') : (vec4(1) as unknown as Node<'vec4'>)
    const colour = mixValues('baseColor', own.rgb as Node<'vec3'>, inputs, shares)
    added.colorNode = vec4(reference<'vec3'>('color', 'color').mul(colour) as Node<'vec3'>, own.a) as never
  }
  if (roughness && 'roughness' in material) {
    const own = roughnessMap ? vec3(reference<'vec4'>('roughnessMap', 'texture').g) : white
    const value = mixValues('roughness', own as Node<'vec3'>, inputs, shares).x
    added.roughnessNode = reference<'float'>('roughness', 'float').mul(value) as never
  }
  if (occlusion && 'aoMap' in material) {
    const intensity = reference<'float'>('aoMapIntensity', 'float')
    const own = aoMap ? vec3(reference<'vec4'>('aoMap', 'texture').r) : white
    const value = mixValues('occlusion', own as Node<'vec3'>, inputs, shares).x
    added.aoNode = (aoMap ? value.sub(1).mul(intensity).add(1) : value) as never
  }
  return added
}

/** The paper's mode: lit with smooth normals, lit again with wrinkled ones, and the two colours mixed. */
function paper(
  { texture: colours, diffuseIsSrgb }: PaperArray,
  place: Node<'vec2'>,
  shares: Node<'vec4'>,
): Partial<Patched> {
  const sample = (slice: number) =>
    texture(colours, repeat(place)).depth(int(slice)) as unknown as Node<'vec4'>
  const smooth = normalMap(sample(1).xyz, scale())
  const wrinkled = normalMap(sample(2).xyz, scale())
  const stored = sample(0).rgb as Node<'vec3'>
  const diffuse = diffuseIsSrgb ? (sRGBTransferEOTF(stored) as unknown as Node<'vec3'>) : stored
  return {
    colorNode: reference<'vec3'>('color', 'color').mul(diffuse) as never,
    normalNode: smooth as never,
    setupLighting(this: NodeMaterial, builder: NodeBuilder) {
      // One lighting graph, run twice by a loop: built twice, three.js would share the first's variables.
      const colour = vec3(0).toVar()
      const normals = [inView(smooth).toVar(), inView(wrinkled).toVar()]
      const amount = shares.x.toVar()
      Loop(2, ({ i }) => {
        const isSecond = int(i as unknown as Node<'int'>).equal(1)
        normalView.assign(select(isSecond, normals[1], normals[0]) as Node<'vec3'>)
        normalWorld.assign(normalView.transformNormalByInverseViewMatrix(cameraViewMatrix))
        const lit = vec3(Object.getPrototypeOf(this).setupLighting.call(this, builder) as Node<'vec3'>)
        colour.addAssign(lit.mul(select(isSecond, amount, amount.oneMinus())))
      })
      return colour
    },
  }
}

/** A normal in view space, built as three.js builds the material's own. */
function inView(normal: Node<'vec3'>): Node<'vec3'> {
  return subBuild(normal, 'NORMAL', 'vec3') as unknown as Node<'vec3'>
}

function scale(): Node<'vec2'> {
  return reference('normalScale', 'vec2')
}

/** A property of the material, as it is when it is drawn. */
function reference<T extends string>(property: string, type: string): Node<T> {
  return materialReference(property, type as never) as unknown as Node<T>
}
