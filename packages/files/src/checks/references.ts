import type { CheckedJson } from '../json/checked-json.ts'
import { compressedViews } from '../json/gltf-json.ts'

/** JSON path of an index in the file, its value, and the list that it refers to. */
type Reference = [where: string, index: number | undefined, list: readonly unknown[] | undefined]

/** Finds the first invalid index in a file. Call `shapeProblem` first. Returns an error text, or undefined. */
export function referenceProblem(json: CheckedJson): string | undefined {
  for (const [where, index, list = []] of referencesOf(json)) {
    if (index !== undefined && index >= list.length)
      return `${where} is ${index}, but the list has ${list.length} items`
  }
  for (const [i, { source, extensions = {} }] of (json.textures ?? []).entries()) {
    if (source === undefined && Object.keys(extensions).length === 0) return `textures[${i}] has no image`
  }
  return dracoAttributeProblem(json)
}

/** Checks that a primitive lists every attribute that its Draco data has (KHR_draco_mesh_compression). */
function dracoAttributeProblem({ meshes = [] }: CheckedJson): string | undefined {
  for (const [m, { primitives }] of meshes.entries()) {
    for (const [p, { attributes = {}, extensions }] of primitives.entries()) {
      const packed = Object.keys(extensions?.KHR_draco_mesh_compression?.attributes ?? {})
      const extra = packed.find((name) => !Object.hasOwn(attributes, name))
      if (extra !== undefined)
        return `meshes[${m}].primitives[${p}] lists ${extra} only in its Draco extension`
    }
  }
  return undefined
}

function* referencesOf(json: CheckedJson): Generator<Reference> {
  const {
    accessors,
    bufferViews,
    buffers,
    cameras,
    images,
    materials,
    meshes,
    nodes,
    samplers,
    scenes,
    skins,
  } = json
  yield ['scene', json.scene, scenes]
  for (const [i, view] of (bufferViews ?? []).entries()) {
    yield [`bufferViews[${i}].buffer`, view.buffer, buffers]
    for (const { buffer } of compressedViews(view))
      yield [`bufferViews[${i}].extensions.buffer`, buffer, buffers]
  }
  for (const [i, { bufferView, sparse }] of (accessors ?? []).entries()) {
    yield [`accessors[${i}].bufferView`, bufferView, bufferViews]
    yield [`accessors[${i}].sparse.indices.bufferView`, sparse?.indices.bufferView, bufferViews]
    yield [`accessors[${i}].sparse.values.bufferView`, sparse?.values.bufferView, bufferViews]
  }
  for (const [i, { bufferView }] of (images ?? []).entries())
    yield [`images[${i}].bufferView`, bufferView, bufferViews]
  for (const [i, { sampler, source, extensions = {} }] of (json.textures ?? []).entries()) {
    yield [`textures[${i}].sampler`, sampler, samplers]
    yield [`textures[${i}].source`, source, images]
    for (const [name, { source }] of Object.entries(extensions)) {
      yield [`textures[${i}].extensions.${name}.source`, source, images]
    }
  }
  for (const [i, material] of (materials ?? []).entries()) {
    for (const [name, info] of textureInfosOf(material))
      yield [`materials[${i}].${name}.index`, info.index, json.textures]
  }
  for (const [m, { primitives }] of (meshes ?? []).entries()) {
    for (const [
      p,
      { attributes = {}, targets = [], indices, material, extensions },
    ] of primitives.entries()) {
      const where = `meshes[${m}].primitives[${p}]`
      yield [`${where}.material`, material, materials]
      yield [`${where}.indices`, indices, accessors]
      yield [`${where}.draco.bufferView`, extensions?.KHR_draco_mesh_compression?.bufferView, bufferViews]
      for (const [list, of] of [attributes, ...targets].entries()) {
        const part = list === 0 ? 'attributes' : `targets[${list - 1}]`
        for (const [name, index] of Object.entries(of)) yield [`${where}.${part}.${name}`, index, accessors]
      }
    }
  }
  for (const [i, { mesh, skin, camera, children = [] }] of (nodes ?? []).entries()) {
    yield [`nodes[${i}].mesh`, mesh, meshes]
    yield [`nodes[${i}].skin`, skin, skins]
    yield [`nodes[${i}].camera`, camera, cameras]
    for (const child of children) yield [`nodes[${i}].children`, child, nodes]
  }
  for (const [i, { joints, skeleton, inverseBindMatrices }] of (skins ?? []).entries()) {
    yield [`skins[${i}].skeleton`, skeleton, nodes]
    yield [`skins[${i}].inverseBindMatrices`, inverseBindMatrices, accessors]
    for (const joint of joints) yield [`skins[${i}].joints`, joint, nodes]
  }
  for (const [i, { nodes: roots = [] }] of (scenes ?? []).entries()) {
    for (const root of roots) yield [`scenes[${i}].nodes`, root, nodes]
  }
  for (const [i, { channels, samplers }] of (json.animations ?? []).entries()) {
    for (const { sampler, target } of channels) {
      yield [`animations[${i}].channels.sampler`, sampler, samplers]
      yield [`animations[${i}].channels.target.node`, target.node, nodes]
    }
    for (const { input, output } of samplers) {
      yield [`animations[${i}].samplers.input`, input, accessors]
      yield [`animations[${i}].samplers.output`, output, accessors]
    }
  }
}

/** Returns the texture infos of a material by name, without the textures of its extensions. */
function textureInfosOf(material: NonNullable<CheckedJson['materials']>[number]) {
  const { normalTexture, occlusionTexture, emissiveTexture, pbrMetallicRoughness = {} } = material
  const { baseColorTexture, metallicRoughnessTexture } = pbrMetallicRoughness
  const infos = {
    normalTexture,
    occlusionTexture,
    emissiveTexture,
    baseColorTexture,
    metallicRoughnessTexture,
  }
  return Object.entries(infos).flatMap(([name, info]) => (info ? [[name, info] as const] : []))
}
