type Extensions = Record<string, unknown>

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

/** Compressed data of a buffer view, from EXT_meshopt_compression or KHR_meshopt_compression. */
export interface CompressedView {
  buffer: number
  byteOffset?: number
  byteLength: number
  count: number
  byteStride: number
}

/** Properties of a glTF file that Furrow reads or changes. Furrow keeps all other properties. */
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
  animations?: object[]
  extensions?: Extensions
}

/** Returns the names that three.js gives to the blendshapes of a mesh. */
export function targetNamesOf({ primitives, extras }: GltfMesh): string[] {
  return namesOfTargets(extras?.targetNames, primitives[0]?.targets?.length ?? 0)
}

/**
 * Returns the names of `count` blendshapes. A blendshape without a name gets its index as its name.
 *
 * @param names `extras.targetNames` of the mesh, of any type. Ignored unless it is an array of length `count`.
 */
export function namesOfTargets(names: unknown, count: number): string[] {
  const given = Array.isArray(names) && names.length === count ? names : []
  return Array.from({ length: count }, (_, i) => String(typeof given[i] === 'object' ? i : (given[i] ?? i)))
}

/** Returns the names of all nodes that have one. Drivers can use any of these nodes as a joint. */
export function jointNamesOf({ nodes = [] }: GltfJson): string[] {
  return nodes.flatMap(({ name }) => (name === undefined ? [] : [name]))
}

/**
 * Returns the compressed data of a buffer view, per compression extension. Returns an empty list for uncompressed
 * buffer views.
 */
export function compressedViews({ extensions = {} }: BufferView): CompressedView[] {
  return Object.values(extensions).filter((value) => value.byteLength !== undefined) as CompressedView[]
}
