import type { Accessor, Primitive } from '@gltf-transform/core'
import { morphNormalDeltas } from 'furrow'
import { readDocument } from '../face.ts'
import type { Progress } from '../progress.ts'
import type { Glb, GltfJson } from './glb-file.ts'
import { ViewAdder } from './view-adder.ts'

/** Change of a normal, per axis, that is not worth its bytes: half a step of a byte. */
const NOTHING = 1 / 510
/** Share of vertices above which a list of those that change is no shorter than all. */
const FEW = 0.7

const UNSIGNED_INT = 5125
const FLOAT = 5126

/**
 * Gives the morph targets of one mesh normals where they have none, so that light follows what they do.
 *
 * @param glb changed in place; what is there keeps its index.
 * @param path of the file it was read from, which is read once more with whatever compression it has.
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
  const adder = new ViewAdder(glb)
  let [done, added] = [0, 0]
  const total = primitives.reduce((sum, primitive) => sum + primitive.listTargets().length, 0)
  for (const [i, primitive] of primitives.entries()) {
    const changes = changesOf(primitive)
    for (const [k, target] of primitive.listTargets().entries()) {
      progress(++done, total)
      const offsets = target.getAttribute('POSITION')
      if (!changes || !offsets || target.getAttribute('NORMAL')) continue
      const own = glb.json.meshes![mesh].primitives[i].targets![k]
      own.NORMAL = addAccessor(glb.json, adder, changes(numbersOf(offsets)))
      added++
    }
  }
  adder.finish()
  return added
}

/** What targets of a primitive do to its normals; nothing where it has none. */
function changesOf(primitive: Primitive): ReturnType<typeof morphNormalDeltas> | undefined {
  const [position, normal] = [primitive.getAttribute('POSITION'), primitive.getAttribute('NORMAL')]
  if (!position || !normal) return undefined
  const triangles =
    primitive.getIndices()?.getArray() ?? Uint32Array.from({ length: position.getCount() }, (_, i) => i)
  return morphNormalDeltas({ positions: numbersOf(position), normals: numbersOf(normal), triangles })
}

/** Quantised or not. */
function numbersOf(accessor: Accessor): Float32Array {
  const out = new Float32Array(3 * accessor.getCount())
  const element: number[] = []
  for (let i = 0; i < accessor.getCount(); i++) out.set(accessor.getElement(i, element), 3 * i)
  return out
}

function addAccessor(json: GltfJson, adder: ViewAdder, changes: Float32Array): number {
  const count = changes.length / 3
  const moved = Array.from({ length: count }, (_, i) => i).filter((i) =>
    [0, 1, 2].some((k) => Math.abs(changes[3 * i + k]) > NOTHING),
  )
  const accessor = { componentType: FLOAT, type: 'VEC3', count }
  json.accessors ??= []
  // glTF wants at least one entry in a sparse accessor, and has zeros where there is no view at all.
  if (moved.length === 0) return json.accessors.push(accessor) - 1
  if (moved.length > FEW * count)
    return json.accessors.push({ ...accessor, bufferView: adder.add(bytesOf(changes)) }) - 1
  const values = Float32Array.from(moved.flatMap((i) => [...changes.subarray(3 * i, 3 * i + 3)]))
  const sparse = {
    count: moved.length,
    indices: { bufferView: adder.add(bytesOf(Uint32Array.from(moved))), componentType: UNSIGNED_INT },
    values: { bufferView: adder.add(bytesOf(values)) },
  }
  return json.accessors.push({ ...accessor, sparse }) - 1
}

function bytesOf({ buffer, byteOffset, byteLength }: Float32Array | Uint32Array): Uint8Array {
  return new Uint8Array(buffer, byteOffset, byteLength)
}
