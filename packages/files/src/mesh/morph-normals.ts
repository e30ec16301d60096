import type { Accessor, Primitive } from '@gltf-transform/core'
import { morphNormalDeltas } from 'furrow/internal'
import type { Progress } from '../base/progress.ts'
import { BufferViewWriter } from '../gltf/buffer-view-writer.ts'
import { documentOf } from '../gltf/document.ts'
import type { Glb } from '../gltf/glb.ts'
import type { GltfJson } from '../json/gltf-json.ts'

/**
 * Sparse accessors omit deltas whose components are all at most this: a quarter of the step of an 8-bit normal map.
 */
const NEGLIGIBLE = 1 / 510
/** Above this fraction of changed vertices, a sparse accessor would not be smaller than a full one. */
const MAX_SPARSE_FRACTION = 0.7

// Component types of glTF (glTF 2.0, 3.6.2.2).
const UNSIGNED_INT = 5125
const FLOAT = 5126

/**
 * Adds normals to those blendshapes of a mesh that have positions but no normals, so that shading follows the surface
 * that they move. Skips primitives without normals.
 *
 * @param glb changed in place. Existing indices stay valid.
 * @param path path of the source file, for errors.
 * @param mesh index of the mesh.
 * @returns number of morph targets that got normals.
 * @throws FurrowError if the geometry cannot be decoded.
 */
export async function addMorphNormals(
  glb: Glb,
  path: string,
  mesh: number,
  who: string,
  progress: Progress = () => {},
): Promise<number> {
  const document = await documentOf(glb, path, who)
  const primitives = document.getRoot().listMeshes()[mesh].listPrimitives()
  const views = new BufferViewWriter(glb)
  let [done, added] = [0, 0]
  const total = primitives.reduce((sum, primitive) => sum + primitive.listTargets().length, 0)
  for (const [i, { targets = [] }] of (glb.json.meshes?.[mesh].primitives ?? []).entries()) {
    const deltasOf = normalDeltasOf(primitives[i])
    for (const [k, target] of primitives[i].listTargets().entries()) {
      progress(++done, total)
      const offsets = target.getAttribute('POSITION')
      if (!deltasOf || !offsets || target.getAttribute('NORMAL')) continue
      targets[k].NORMAL = addAccessor(glb.json, views, deltasOf(readVectors(offsets)))
      added++
    }
  }
  views.finish()
  return added
}

/**
 * Returns a function that converts position deltas of a morph target to normal deltas. Returns undefined if the
 * primitive has no normals.
 */
function normalDeltasOf(primitive: Primitive): ReturnType<typeof morphNormalDeltas> | undefined {
  const [position, normal] = [primitive.getAttribute('POSITION'), primitive.getAttribute('NORMAL')]
  if (!position || !normal) return undefined
  const triangles =
    primitive.getIndices()?.getArray() ?? Uint32Array.from({ length: position.getCount() }, (_, i) => i)
  return morphNormalDeltas({ positions: readVectors(position), normals: readVectors(normal), triangles })
}

function readVectors(accessor: Accessor): Float32Array {
  const out = new Float32Array(3 * accessor.getCount())
  const element: number[] = []
  for (let i = 0; i < accessor.getCount(); i++) out.set(accessor.getElement(i, element), 3 * i)
  return out
}

function addAccessor(json: GltfJson, views: BufferViewWriter, deltas: Float32Array): number {
  const count = deltas.length / 3
  const changed = Array.from({ length: count }, (_, i) => i).filter((i) =>
    [0, 1, 2].some((k) => Math.abs(deltas[3 * i + k]) > NEGLIGIBLE),
  )
  const accessor = { componentType: FLOAT, type: 'VEC3', count }
  json.accessors ??= []
  // An accessor without a buffer view is all zeros. A sparse accessor would need at least one entry.
  if (changed.length === 0) return json.accessors.push(accessor) - 1
  if (changed.length > MAX_SPARSE_FRACTION * count) {
    return json.accessors.push({ ...accessor, bufferView: views.add(bytesOf(deltas)) }) - 1
  }
  const values = Float32Array.from(changed.flatMap((i) => [...deltas.subarray(3 * i, 3 * i + 3)]))
  const sparse = {
    count: changed.length,
    indices: { bufferView: views.add(bytesOf(Uint32Array.from(changed))), componentType: UNSIGNED_INT },
    values: { bufferView: views.add(bytesOf(values)) },
  }
  return json.accessors.push({ ...accessor, sparse }) - 1
}

function bytesOf({ buffer, byteOffset, byteLength }: Float32Array | Uint32Array): Uint8Array {
  return new Uint8Array(buffer, byteOffset, byteLength)
}
