type Extensions = Record<string, unknown>

/** A reference to a texture. */
export interface TextureInfo {
  index: number
  texCoord?: number
  extensions?: Extensions
}

export interface GltfMaterial {
  name?: string
  pbrMetallicRoughness?: { baseColorTexture?: TextureInfo }
  normalTexture?: TextureInfo
  extensions?: Extensions
}

export interface GltfMesh {
  name?: string
  primitives: {
    attributes?: Record<string, number>
    indices?: number
    mode?: number
    material?: number
    targets?: Record<string, number>[]
  }[]
  extras?: { targetNames?: unknown }
}

export interface BufferView {
  buffer: number
  byteOffset?: number
  byteLength: number
  byteStride?: number | undefined
  extensions?: Record<string, Partial<CompressedView>>
}

/** The bytes that a view is decompressed from, by EXT_meshopt_compression or a successor. */
export interface CompressedView {
  buffer: number
  byteOffset?: number
  byteLength: number
  count: number
  byteStride: number
}

/** The parts of a glTF document that wrinkles touch; everything else is kept as it is. */
export interface GltfJson {
  extensionsUsed?: string[]
  extensionsRequired?: string[]
  buffers?: { byteLength: number; uri?: string }[]
  bufferViews?: BufferView[]
  accessors?: object[]
  images?: { name?: string; mimeType?: string; uri?: string; bufferView?: number }[]
  textures?: { name?: string; sampler?: number; source?: number; extensions?: Extensions }[]
  samplers?: object[]
  materials?: GltfMaterial[]
  meshes?: GltfMesh[]
  nodes?: { name?: string; mesh?: number; children?: number[] }[]
  scenes?: { nodes?: number[] }[]
  extensions?: Extensions
}

/** Names of the blendshapes of a mesh, as three.js and others know them. */
export function targetNamesOf({ primitives, extras }: GltfMesh): string[] {
  return namesOfTargets(extras?.targetNames, primitives[0]?.targets?.length ?? 0)
}

/**
 * Names of `count` blendshapes, each of which has an index for a name where it has none.
 *
 * @param names `extras.targetNames` of their mesh, whatever it is; ignored where it has too few or too many.
 */
export function namesOfTargets(names: unknown, count: number): string[] {
  const given = Array.isArray(names) && names.length === count ? names : []
  return Array.from({ length: count }, (_, i) => String(typeof given[i] === 'object' ? i : (given[i] ?? i)))
}

/** Names of all nodes: drivers may name any of them as a joint. */
export function jointNamesOf({ nodes = [] }: GltfJson): string[] {
  return nodes.flatMap(({ name }) => (name === undefined ? [] : [name]))
}

/** Lists the compressed data of a buffer view, one entry per compression extension; empty if uncompressed. */
export function compressedViews({ extensions = {} }: BufferView): CompressedView[] {
  return Object.values(extensions).filter((value) => value.byteLength !== undefined) as CompressedView[]
}
