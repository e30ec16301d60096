/** Converts glTF files to VRM files that three-vrm accepts. */

import { editGlb } from './glb.ts'

type Edit = Parameters<typeof editGlb>[1]
type Json = Parameters<Edit>[0]

/** Shader name in VRM 0. `VRM_USE_GLTFSHADER` keeps the glTF material. For other shaders, three-vrm makes a material from Unity properties. */
export type Vrm0Shader = 'VRM_USE_GLTFSHADER' | 'VRM/MToon' | 'VRM/UnlitTexture'

const LIMBS = ['left', 'right'].flatMap((side) =>
  ['UpperLeg', 'LowerLeg', 'Foot', 'UpperArm', 'LowerArm', 'Hand'].map((bone) => side + bone),
)

/** Bones required by VRM 1.0. */
const BONES = ['hips', 'spine', 'head', ...LIMBS]

/** Bones required by VRM 0. */
const BONES_0 = ['hips', 'spine', 'chest', 'neck', 'head', ...LIMBS]

const OUTLINE = { outlineWidthMode: 'worldCoordinates', outlineWidthFactor: 0.01 }

/**
 * Converts a file to VRM 1.0 with bones that move no vertex.
 *
 * @param change edits the JSON further.
 */
export function asVrm1(file: Uint8Array, change: Edit = () => {}): Uint8Array<ArrayBuffer> {
  return editGlb(file, (json) => {
    const first = addNodes(json, BONES)
    json.extensionsUsed = [...(json.extensionsUsed ?? []), 'VRMC_vrm']
    const humanBones = Object.fromEntries(BONES.map((name, i) => [name, { node: first + i }]))
    const meta = { name: 'face', authors: ['nobody'], licenseUrl: 'https://vrm.dev/licenses/1.0/' }
    json.extensions = { VRMC_vrm: { specVersion: '1.0', meta, humanoid: { humanBones } } }
    change(json)
  })
}

/** Converts all materials of a VRM 1.0 file to MToon. Use as `change` of `asVrm1`. */
export function addMToon(json: Json, hasOutline = false): void {
  const mtoon = { specVersion: '1.0', shadeColorFactor: [0.7, 0.4, 0.4], ...(hasOutline && OUTLINE) }
  reduceToToon(json, { VRMC_materials_mtoon: mtoon })
  json.extensionsUsed.push('VRMC_materials_mtoon')
}

/**
 * Gives all materials an extension, and removes their other extensions except wrinkles. Removes textures and attributes that MToon ignores, and
 * tangents, with which MToon does not compile.
 */
function reduceToToon(json: Json, extension: object): void {
  for (const material of json.materials) {
    const { FURROW_wrinkle_maps } = material.extensions ?? {}
    material.extensions = { ...(FURROW_wrinkle_maps && { FURROW_wrinkle_maps }), ...extension }
    delete material.occlusionTexture
    delete material.pbrMetallicRoughness?.metallicRoughnessTexture
  }
  for (const { attributes } of json.meshes.flatMap(({ primitives }: Json) => primitives)) {
    delete attributes.TANGENT
    delete attributes.COLOR_0
  }
}

/**
 * Converts a file to VRM 0 with bones that move no vertex.
 *
 * @param shader shader of all materials. For Unity shaders, materials also get `KHR_materials_unlit`, as exporters do.
 * @param change edits the JSON further.
 */
export function asVrm0(
  file: Uint8Array,
  shader: Vrm0Shader = 'VRM_USE_GLTFSHADER',
  change: Edit = () => {},
): Uint8Array<ArrayBuffer> {
  return editGlb(file, (json) => {
    const first = addNodes(json, BONES_0)
    const humanBones = BONES_0.map((bone, i) => ({ bone, node: first + i, useDefaultValues: true }))
    const isOwn = shader === 'VRM_USE_GLTFSHADER'
    json.extensionsUsed = [...(json.extensionsUsed ?? []), 'VRM', ...(isOwn ? [] : ['KHR_materials_unlit'])]
    json.extensions = {
      VRM: {
        specVersion: '0.0',
        meta: { title: 'face' },
        humanoid: { humanBones },
        blendShapeMaster: { blendShapeGroups: [] },
        materialProperties: json.materials.map((material: Material) => propertiesOf(material, shader)),
      },
    }
    if (!isOwn) reduceToToon(json, { KHR_materials_unlit: {} })
    change(json)
  })
}

interface Material {
  name: string
  pbrMetallicRoughness?: { baseColorTexture?: { index: number } }
  normalTexture?: { index: number }
}

/** Returns a glTF material as properties of a Unity shader. */
function propertiesOf({ name, pbrMetallicRoughness, normalTexture }: Material, shader: Vrm0Shader): object {
  const isMToon = shader === 'VRM/MToon'
  const baseColor = pbrMetallicRoughness?.baseColorTexture?.index
  return {
    name,
    shader,
    renderQueue: 2000,
    floatProperties: isMToon ? { _ShadeToony: 0.9, _BumpScale: 1, _CullMode: 2 } : {},
    vectorProperties: isMToon ? { _Color: [1, 1, 1, 1], _ShadeColor: [0.85, 0.66, 0.66, 1] } : {},
    textureProperties:
      shader === 'VRM_USE_GLTFSHADER'
        ? {}
        : {
            ...(baseColor !== undefined && { _MainTex: baseColor }),
            ...(isMToon && baseColor !== undefined && { _ShadeTexture: baseColor }),
            ...(isMToon && normalTexture && { _BumpMap: normalTexture.index }),
          },
    keywordMap: {},
    tagMap: {},
  }
}

/** Adds nodes to a file's first scene. Returns the index of the first added node. */
function addNodes(json: Json, names: readonly string[]): number {
  const first = json.nodes.length
  json.nodes.push(...names.map((name) => ({ name })))
  json.scenes[0].nodes.push(...names.map((_, i) => first + i))
  return first
}
