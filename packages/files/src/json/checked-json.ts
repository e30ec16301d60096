import type { GltfJson, GltfMaterial, GltfMesh, TextureInfo } from './gltf-json.ts'

export interface CheckedAccessor {
  bufferView?: number
  byteOffset?: number
  componentType: number
  count: number
  normalized?: boolean
  type: string
  sparse?: {
    count: number
    indices: { bufferView: number; byteOffset?: number; componentType: number }
    values: { bufferView: number; byteOffset?: number }
  }
}

/** glTF JSON with the additional properties that the checks read. `shapeProblem` has checked their types. */
export interface CheckedJson
  extends Omit<GltfJson, 'accessors' | 'materials' | 'meshes' | 'nodes' | 'textures'> {
  accessors?: CheckedAccessor[]
  cameras?: object[]
  materials?: (GltfMaterial & {
    pbrMetallicRoughness?: { metallicRoughnessTexture?: TextureInfo }
    occlusionTexture?: TextureInfo
    emissiveTexture?: TextureInfo
  })[]
  meshes?: (Omit<GltfMesh, 'primitives'> & {
    primitives: (GltfMesh['primitives'][number] & {
      extensions?: { KHR_draco_mesh_compression?: { bufferView: number; attributes: Record<string, number> } }
    })[]
  })[]
  nodes?: { name?: string; mesh?: number; skin?: number; camera?: number; children?: number[] }[]
  textures?: { sampler?: number; source?: number; extensions?: Record<string, { source?: number }> }[]
  scene?: number
  scenes?: { nodes?: number[] }[]
  skins?: { joints: number[]; skeleton?: number; inverseBindMatrices?: number }[]
  animations?: {
    channels: { sampler: number; target: { node?: number } }[]
    samplers: { input: number; output: number }[]
  }[]
}
