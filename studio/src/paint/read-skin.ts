import { FurrowError } from 'furrow'
import type { Skin } from 'furrow/author'
import { joinParts, type SkinPart } from 'furrow/internal'
import { placementOf, vectorsOf } from 'furrow/internal/three'
import {
  type BufferAttribute,
  type InterleavedBufferAttribute,
  type Mesh,
  type MeshStandardMaterial,
  Vector2,
} from 'three'

/** Meshes of a face joined into one skin. */
export interface MeshSkin {
  skin: Skin
  /** Indices of each mesh's vertices, in the order in which the skin contains them. */
  parts: readonly { mesh: Mesh; vertices: Uint32Array }[]
}

/**
 * Reads the meshes of a face's skin and joins them.
 *
 * @throws FurrowError if a mesh has no texture coordinates.
 */
export function readSkin(meshes: readonly [Mesh, ...Mesh[]]): MeshSkin {
  const parts: { mesh: Mesh; vertices: Uint32Array }[] = []
  const [first] = meshes
  const targets = first.geometry.morphAttributes.position?.map((_, i) => String(i)) ?? []
  for (const [name, i] of Object.entries(first.morphTargetDictionary ?? {})) targets[i] = name
  const skin = joinParts(
    meshes.map((mesh) => partOf(mesh, (vertices) => parts.push({ mesh, vertices }))),
    targets,
    placementOf(first).toArray(),
  )
  return { skin, parts }
}

function partOf({ geometry, material, name }: Mesh, use: (vertices: Uint32Array) => void): SkinPart {
  const { attributes, morphAttributes, morphTargetsRelative, index } = geometry
  const { normalMap } = material as MeshStandardMaterial
  const uvs = (normalMap?.channel && attributes[`uv${normalMap.channel}`]) || attributes.uv
  if (!uvs) {
    throw new FurrowError({
      who: 'Studio',
      problem: 'a mesh without texture coordinates cannot be painted',
      value: name,
      remedy: 'unwrap it',
    })
  }
  normalMap?.updateMatrix()
  const uv = new Vector2()
  const { count } = attributes.position
  return {
    count,
    indices: index?.array ?? Uint32Array.from({ length: count }, (_, i) => i),
    readPositions(vertices, out) {
      use(vertices)
      readVectors(attributes.position, vertices, out)
    },
    readUvs(vertices, out) {
      for (const [i, vertex] of vertices.entries()) {
        uv.fromBufferAttribute(uvs as BufferAttribute, vertex)
        if (normalMap) uv.applyMatrix3(normalMap.matrix)
        uv.toArray(out, 2 * i)
      }
    },
    readOffsets(target, vertices, out) {
      const moved = morphAttributes.position?.[target]
      if (!moved) return
      readVectors(moved, vertices, out)
      if (morphTargetsRelative) return
      const rest = new Float32Array(out.length)
      readVectors(attributes.position, vertices, rest)
      for (let i = 0; i < out.length; i++) out[i] -= rest[i]
    },
  }
}

function readVectors(
  attribute: BufferAttribute | InterleavedBufferAttribute,
  vertices: Uint32Array,
  out: Float32Array,
): void {
  const vectors = vectorsOf(attribute, vertices)
  for (let i = 0; i < vertices.length; i++) {
    for (let k = 0; k < 3; k++) out[3 * i + k] = vectors[3 * vertices[i] + k]
  }
}
