import type { Mesh, MeshStandardMaterial } from 'three'
import {
  bitangentView,
  cameraViewMatrix,
  int,
  Loop,
  mat3,
  normalMap,
  normalView,
  normalWorld,
  select,
  sRGBTransferEOTF,
  tangentView,
  texture,
  vec3,
  vec4,
} from 'three/tsl'
import type { MeshStandardNodeMaterial, Node, NodeBuilder, NodeMaterial } from 'three/webgpu'
import type { ArraySlice, WrinkleSet } from '../../core/types.ts'
import { instancesOf } from '../instances.ts'
import type { PaperArray } from '../material/paper-array.ts'
import type { RendererParts } from '../material/renderer-parts.ts'
import type { ShaderInputs } from '../material/shader-inputs.ts'
import { isToon, type WrinkleMaterial } from '../material/wrinkle-material.ts'
import type { WrinklesOptions } from '../options.ts'
import { checkThree } from '../three-version.ts'
import { WrinklesBase } from '../wrinkles-base.ts'
import { faultOf, unwatch, watched } from './build-fault.ts'
import { composeMaterial } from './compose-material.ts'
import { checkBatch, influenceFromAreas, influenceFromMap } from './influence.ts'
import { influenceMaterial } from './influence-material.ts'
import { quadMaterials } from './influence-quads.ts'
import { shadowHighlights } from './micro-shadow.ts'
import { bloodColour, type LayerInfluence, mixNormals, mixValues, toonColour } from './mix.ts'
import { materialProperty, normalInView, typed } from './node.ts'
import { mapUv, repeat } from './texture-sampling.ts'

/** The wrinkles of a loaded file, whose drivers the loader adds; `Wrinkles` is the same for all else. */
export class WebGPUWrinkles extends WrinklesBase {
  constructor(mesh: Mesh, source: WrinkleSet<ArraySlice> | WrinklesBase, options: WrinklesOptions = {}) {
    checkThree('Wrinkles of furrow/webgpu')
    if (instancesOf(mesh) === 'batched') checkBatch(mesh)
    super(PARTS, mesh, source, options)
  }
}

const PATCHED = [
  'normalNode',
  'colorNode',
  'roughnessNode',
  'aoNode',
  'setupLighting',
  'setupLightingModel',
  'customProgramCacheKey',
] as const

/** What the patch sets; plain materials carry these too, the renderer copies them to the nodes it makes. */
type Patched = WrinkleMaterial &
  Partial<Pick<MeshStandardNodeMaterial, Exclude<(typeof PATCHED)[number], 'customProgramCacheKey'>>>

/** What it sets in any mode, and more. */
type Added = Partial<Patched> & { normalNode: Node<'vec3'> }

let patchCount = 0

const patch: RendererParts['patch'] = (material: Patched, inputs, mode, instances) => {
  const original = Object.fromEntries(
    PATCHED.filter((key) => Object.hasOwn(material, key)).map((key) => [key, material[key]]),
  )
  const uv = mapUv(material)
  const added =
    mode === 'paper'
      ? paperNodes(inputs.paper!, uv, influenceFromAreas(inputs, inputs.paper!.table, uv))
      : layerNodes(material, inputs, { influence: influenceFromMap(inputs, uv, instances), uv })
  Object.assign(material, added, { normalNode: watched(material, added.normalNode) })
  // The renderer shares one built program among plain materials with equal properties, and nodes are not
  // among those it compares; these read textures of their own.
  const variant = `furrow ${mode} ${patchCount++}`
  const cacheKey = material.customProgramCacheKey
  material.customProgramCacheKey = () => `${cacheKey.call(material)} ${variant}`
  return () => {
    unwatch(material)
    for (const key of [...Object.keys(added), 'customProgramCacheKey']) Reflect.deleteProperty(material, key)
    Object.assign(material, original)
  }
}

const PARTS: RendererParts = {
  entry: 'furrow/webgpu',
  canPatch: () => true,
  patch,
  renew: (material) => {
    material.needsUpdate = true
  },
  faultOf,
  composeMaterial,
  influenceMaterial,
  quads: quadMaterials,
  loadRelief: async () => (await import('./relief.ts')).RELIEF_PARTS,
}

/** The default mode: the layers' maps mixed into the material's, lit once. */
function layerNodes(material: Patched, inputs: ShaderInputs, layers: LayerInfluence): Added {
  const { normalNode } = material
  const ownNormal = normalNode ? vec3(0.5, 0.5, 1) : materialProperty('normalMap', 'texture').xyz
  const mixed = mixNormals(ownNormal, inputs, layers)
  const added: Added = {
    normalNode: normalNode ? ontoNormal(typed(normalNode), mixed) : normalMap(mixed, normalScale()),
  }
  const { baseColor, roughness, occlusion, blood } = inputs.textures.values
  const { map, roughnessMap, aoMap } = material as Partial<MeshStandardMaterial>
  if (baseColor || blood || isToon(material)) {
    const own = map ? materialProperty('map', 'texture') : vec4(1)
    const mapped = baseColor ? mixValues('baseColor', own.rgb, inputs, layers) : own.rgb
    const unflushed = materialProperty('color', 'color').mul(mapped)
    const colour = blood ? bloodColour(unflushed, mixValues('blood', vec3(0), inputs, layers).x) : unflushed
    added.colorNode = vec4(isToon(material) ? toonColour(colour, ownNormal, mixed) : colour, own.a)
  }
  if (roughness && 'roughness' in material) {
    const own = roughnessMap ? vec3(materialProperty('roughnessMap', 'texture').g) : vec3(1)
    const value = mixValues('roughness', own, inputs, layers).x
    added.roughnessNode = materialProperty('roughness', 'float').mul(value)
  }
  if (occlusion && 'aoMap' in material) {
    const own = aoMap ? vec3(materialProperty('aoMap', 'texture').r) : vec3(1)
    const value = mixValues('occlusion', own, inputs, layers).x
    const intensity = materialProperty('aoMapIntensity', 'float')
    added.aoNode = aoMap ? value.sub(1).mul(intensity).add(1) : value
    const visibility = aoMap ? mixValues('occlusion', vec3(1), inputs, layers).x : value
    added.setupLightingModel = function (this: NodeMaterial) {
      const model = Object.getPrototypeOf(this).setupLightingModel.call(this)
      return shadowHighlights(model, visibility)
    }
  }
  return added
}

/** The paper's mode: lit with smooth normals, lit again with wrinkled ones, and the two colours mixed. */
function paperNodes(
  { texture: colours, diffuseIsSrgb }: PaperArray,
  uv: Node<'vec2'>,
  influence: Node<'vec4'>,
): Added {
  const sample = (slice: number) => texture(colours, repeat(uv)).depth(int(slice))
  const smooth = normalMap(sample(1).xyz, normalScale())
  const wrinkled = normalMap(sample(2).xyz, normalScale())
  const stored = sample(0).rgb
  const diffuse = diffuseIsSrgb ? typed<'vec3'>(sRGBTransferEOTF(stored)) : stored
  return {
    colorNode: materialProperty('color', 'color').mul(diffuse),
    normalNode: smooth,
    setupLighting(this: NodeMaterial, builder: NodeBuilder) {
      // One lighting graph, run twice by a loop: built twice, three.js would share the first's variables.
      const colour = vec3(0).toVar()
      const normals = [normalInView(smooth).toVar(), normalInView(wrinkled).toVar()]
      const amount = influence.x.toVar()
      Loop(2, ({ i }) => {
        const isSecond = int(i).equal(1)
        normalView.assign(select(isSecond, normals[1], normals[0]))
        normalWorld.assign(normalView.transformNormalByInverseViewMatrix(cameraViewMatrix))
        const lit = vec3(Object.getPrototypeOf(this).setupLighting.call(this, builder))
        colour.addAssign(lit.mul(select(isSecond, amount, amount.oneMinus())))
      })
      return colour
    },
  }
}

/** Lays stored normals onto a material's own, in view space, that are not those of a map. */
function ontoNormal(own: Node<'vec3'>, stored: Node<'vec3'>): Node<'vec3'> {
  const normal = stored.mul(2).sub(1).toVar()
  const scaled = vec3(normal.xy.mul(normalScale()), normal.z)
  return mat3(typed<'vec3'>(tangentView), typed<'vec3'>(bitangentView), own).mul(scaled).normalize()
}

function normalScale(): Node<'vec2'> {
  return materialProperty('normalScale', 'vec2')
}
