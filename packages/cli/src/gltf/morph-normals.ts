import type { Accessor, Primitive } from '@gltf-transform/core'
import { normalChanges } from 'furrow'
import type { Progress } from '../progress.ts'
import { BufferViewWriter } from './buffer-view-writer.ts'
import type { Glb } from './glb-file.ts'
import type { GltfJson } from './gltf-json.ts'
import { readDocument } from './read-document.ts'

/** Smallest change of a normal, per axis, that is stored: half a step of an 8-bit normal. */
const MIN_CHANGE = 1 / 510
/** Fraction of changed vertices above which a sparse accessor (an index and a value each) saves too little. */
const MAX_SPARSE = 0.7

// Component types of glTF.
const UNSIGNED_INT = 5125
const FLOAT = 5126

/**
 * Adds normals to the morph targets of one mesh that have none, so that shading follows the shape.
 *
 * @param glb changed in place; existing indices stay valid.
 * @param path of the file that it was read from, which is read again to decompress its meshes.
 * @param mesh index of the mesh.
 * @returns how many targets got normals.
 * @throws FurrowError when the file cannot be read.
 */
export async function addMorphNormals(
  glb: Glb,
  path: string,
  mesh: number,
  who: string,
  progress: Progress = () => {},
): Promise<number> {
  const document = await readDocument(path, who)
  const primitives = document.getRoot().listMeshes()[mesh].listPrimitives()
  const views = new BufferViewWriter(glb)
  let [done, added] = [0, 0]
  const total = primitives.reduce((sum, primitive) => sum + primitive.listTargets().length, 0)
  for (const [i, primitive] of primitives.entries()) {
    const changesOf = normalChangesOf(primitive)
    for (const [k, target] of primitive.listTargets().entries()) {
      progress(++done, total)
      const offsets = target.getAttribute('POSITION')
      if (!changesOf || !offsets || target.getAttribute('NORMAL')) continue
      const stored = glb.json.meshes![mesh].primitives[i].targets![k]
      stored.NORMAL = addAccessor(glb.json, views, changesOf(vectorsOf(offsets)))
      added++
    }
  }
  views.finish()
  return added
}

/** The function from a target's offsets to its changes of normals; undefined where the primitive has no normals. */
function normalChangesOf(primitive: Primitive): ReturnType<typeof normalChanges> | undefined {
  const [position, normal] = [primitive.getAttribute('POSITION'), primitive.getAttribute('NORMAL')]
  if (!position || !normal) return undefined
  const triangles =
    primitive.getIndices()?.getArray() ?? Uint32Array.from({ length: position.getCount() }, (_, i) => i)
  return normalChanges({ positions: vectorsOf(position), normals: vectorsOf(normal), triangles })
}

/** Three floats per element, whatever the accessor's type. */
function vectorsOf(accessor: Accessor): Float32Array {
  const out = new Float32Array(3 * accessor.getCount())
  const element: number[] = []
  for (let i = 0; i < accessor.getCount(); i++) out.set(accessor.getElement(i, element), 3 * i)
  return out
}

function addAccessor(json: GltfJson, views: BufferViewWriter, changes: Float32Array): number {
  const count = changes.length / 3
  const changed = Array.from({ length: count }, (_, i) => i).filter((i) =>
    [0, 1, 2].some((k) => Math.abs(changes[3 * i + k]) > MIN_CHANGE),
  )
  const accessor = { componentType: FLOAT, type: 'VEC3', count }
  json.accessors ??= []
  // A sparse accessor needs at least one entry; an accessor without a buffer view is all zeros (glTF 2.0, 3.6.2).
  if (changed.length === 0) return json.accessors.push(accessor) - 1
  if (changed.length > MAX_SPARSE * count) {
    return json.accessors.push({ ...accessor, bufferView: views.add(bytesOf(changes)) }) - 1
  }
  const values = Float32Array.from(changed.flatMap((i) => [...changes.subarray(3 * i, 3 * i + 3)]))
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
