import { Matrix3, type Mesh } from 'three'
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
  uniform,
  uv,
  vec3,
} from 'three/tsl'
import type { MeshStandardNodeMaterial, Node, NodeBuilder, NodeMaterial } from 'three/webgpu'
import type { WrinkleSet } from '../core/types.ts'
import {
  type RendererParts,
  type WrinkleInputs,
  type WrinkleMaterial,
  WrinklesBase,
  type WrinklesOptions,
} from '../three/Wrinkles.ts'
import { areaCount, influence, mixNormals, sampleLayer } from './functions.ts'
import { influenceMaterial } from './influence-material.ts'

/** Wrinkles on one mesh for `WebGPURenderer`, on WebGPU and on its WebGL 2 backend. */
export class Wrinkles extends WrinklesBase {
  /**
   * @param mesh needs UVs and normals and a material of its own that is lit: a node material or a plain one.
   * @param set copied; later changes to it are not seen, use `addArea` and `removeArea`.
   * @throws FurrowError when the mesh, its material or the set does not fit; the mesh is then untouched.
   */
  constructor(mesh: Mesh, set: WrinkleSet, options: WrinklesOptions = {}) {
    super({ patch, influenceMaterial }, mesh, set, options)
  }
}

/** What the patch sets; plain materials carry these too, the renderer copies them to the nodes it makes. */
type Patched = WrinkleMaterial &
  Partial<Pick<MeshStandardNodeMaterial, 'normalNode' | 'colorNode' | 'setupLighting'>>

const patch: RendererParts['patch'] = (material: Patched, inputs, mode) => {
  const own = Object.fromEntries(
    (['normalNode', 'colorNode', 'setupLighting', 'customProgramCacheKey'] as const)
      .filter((key) => Object.hasOwn(material, key))
      .map((key) => [key, material[key]]),
  )
  const place = mapUv(material)
  const shares = influence(inputs.areas, inputs.activations, areaCount(inputs.areaCount), place)
  const added = mode === 'paper' ? paper(inputs, place, shares) : normals(inputs, place, shares)
  Object.assign(material, added)
  // The renderer shares one built program among plain materials with equal properties, and nodes are not
  // among those it compares; these read textures of their own.
  const variant = `furrow ${mode} ${material.uuid}`
  const cacheKey = material.customProgramCacheKey
  material.customProgramCacheKey = () => `${cacheKey.call(material)} ${variant}`
  return () => {
    for (const key of [...Object.keys(added), 'customProgramCacheKey']) {
      delete (material as unknown as Record<string, unknown>)[key]
    }
    Object.assign(material, own)
  }
}

/** The default mode: normals mixed, lit once. */
function normals(inputs: WrinkleInputs, place: Node<'vec2'>, shares: Node<'vec4'>): Partial<Patched> {
  const base = materialReference('normalMap', 'texture') as unknown as Node<'vec4'>
  const mixed = mixNormals(base.xyz as Node<'vec3'>, inputs.normals, inputs.kinds, shares.toVar(), place)
  return { normalNode: normalMap(mixed, scale()) }
}

/** The paper's mode: lit with smooth normals, lit again with wrinkled ones, and the two colours mixed. */
function paper(inputs: WrinkleInputs, place: Node<'vec2'>, shares: Node<'vec4'>): Partial<Patched> {
  const colours = inputs.colours!
  const smooth = normalMap(sampleLayer(colours, place, 1).xyz, scale())
  const wrinkled = normalMap(sampleLayer(colours, place, 2).xyz, scale())
  const stored = sampleLayer(colours, place, 0).rgb as Node<'vec3'>
  const diffuse = inputs.diffuseIsSrgb ? (sRGBTransferEOTF(stored) as unknown as Node<'vec3'>) : stored
  return {
    colorNode: (materialReference('color', 'color') as unknown as Node<'vec3'>).mul(diffuse) as never,
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

/** UV of the material's normal map, its `KHR_texture_transform` applied. */
function mapUv(material: WrinkleMaterial): Node<'vec2'> {
  const transform = uniform(new Matrix3()).onObjectUpdate(() => {
    const map = material.normalMap!
    if (map.matrixAutoUpdate) map.updateMatrix()
    return map.matrix
  })
  return transform.mul(vec3(uv(material.normalMap!.channel), 1)).xy as Node<'vec2'>
}

function scale(): Node<'vec2'> {
  return materialReference('normalScale', 'vec2') as unknown as Node<'vec2'>
}
