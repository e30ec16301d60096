import type { SkinJoint, SkinSkeleton } from '../../skin/skeleton.ts'
import type { Skin } from '../../skin/surface.ts'

/** Part of a mesh, such as a glTF primitive. The functions read vertex data from the buffers of an engine or a file. */
export interface SkinPart {
  count: number
  /** Three vertices per triangle. */
  indices: ArrayLike<number>
  /** Writes the packed xyz of the given vertices. */
  readPositions(vertices: Uint32Array, out: Float32Array): void
  /** Writes the packed uv of the given vertices, v = 0 at the top. */
  readUvs(vertices: Uint32Array, out: Float32Array): void
  /** Writes the packed xyz offsets by which a target (an index) moves the given vertices. Writes nothing if the target does not move the part. */
  readOffsets(target: number, vertices: Uint32Array, out: Float32Array): void
  /** Writes, for each of the given vertices, its skinning weight for the head joint, 0..1; undefined if the character has no head joint. */
  readHeadWeights?: ((vertices: Uint32Array, out: Float32Array) => void) | undefined
  /** Joints that move the vertices; undefined if none do. */
  influences?: PartInfluences | undefined
}

/** Joints and weights of the vertices of a part. */
export interface PartInfluences {
  /** Number of joints per vertex. */
  count: number
  /** Writes `count` joints (indices into the skeleton) and weights for each of the given vertices. */
  read(vertices: Uint32Array, joints: Uint16Array, weights: Float32Array): void
}

/** Replaces vertex indices that are out of range. `checkSkin` rejects skins with this index. */
const NO_VERTEX = 2 ** 31

/**
 * Joins the parts of a mesh into one skin. Vertices that a part's triangles do not use are dropped, because in many files each part contains
 * all vertices of the mesh.
 *
 * @param names names of the targets.
 * @param placement 4 x 4 matrix from mesh to world space, column-major; default: identity.
 * @param expressions maps the index of a target to the name of a VRM expression that moves only this target.
 * @param joints joints of the skeleton that moves the mesh, in the space into which `placement` transforms.
 */
export function joinParts(
  parts: readonly SkinPart[],
  names: readonly string[],
  placement?: ArrayLike<number>,
  expressions?: ReadonlyMap<number, string>,
  joints?: readonly SkinJoint[],
): Skin {
  const used = parts.map(usedVertices)
  const total = used.reduce((sum, { vertices }) => sum + vertices.length, 0)
  const positions = new Float32Array(3 * total)
  const uvs = new Float32Array(2 * total)
  const offsets = names.map(() => new Float32Array(3 * total))
  const headWeights = parts.some((part) => part.readHeadWeights) ? new Float32Array(total) : undefined
  const indices = new Uint32Array(used.reduce((sum, { corners }) => sum + corners.length, 0))
  let [first, corner] = [0, 0]
  for (const [i, part] of parts.entries()) {
    const { vertices, corners } = used[i]
    const end = first + vertices.length
    part.readPositions(vertices, positions.subarray(3 * first, 3 * end))
    part.readUvs(vertices, uvs.subarray(2 * first, 2 * end))
    if (headWeights) part.readHeadWeights?.(vertices, headWeights.subarray(first, end))
    for (const [k, offset] of offsets.entries()) {
      part.readOffsets(k, vertices, offset.subarray(3 * first, 3 * end))
    }
    for (let k = 0; k < corners.length; k++) indices[corner++] = first + corners[k]
    first = end
  }
  if (placement) {
    transform(positions, placement, 1)
    for (const offset of offsets) transform(offset, placement, 0)
    if (isMirroring(placement)) reverseWinding(indices)
  }
  const targets = names.map((name, k) => {
    const expression = expressions?.get(k)
    return { name, ...(expression !== undefined && { expression }), offsets: offsets[k] }
  })
  const skeleton = joints && joinInfluences(parts, used, joints, total)
  return {
    positions,
    uvs,
    indices,
    targets,
    ...(headWeights && { headWeights }),
    ...(skeleton && { skeleton }),
  }
}

/** Joins the influences of all parts. Returns undefined if no part has any. */
function joinInfluences(
  parts: readonly SkinPart[],
  used: readonly { vertices: Uint32Array }[],
  joints: readonly SkinJoint[],
  total: number,
): SkinSkeleton | undefined {
  const influences = Math.max(...parts.map((part) => part.influences?.count ?? 0))
  if (!(influences > 0)) return undefined
  const indices = new Uint16Array(influences * total)
  const weights = new Float32Array(influences * total)
  let first = 0
  for (const [i, { influences: own }] of parts.entries()) {
    const { vertices } = used[i]
    if (own) {
      const ownJoints = new Uint16Array(own.count * vertices.length)
      const ownWeights = new Float32Array(own.count * vertices.length)
      own.read(vertices, ownJoints, ownWeights)
      for (let k = 0; k < ownJoints.length; k++) {
        const at = influences * (first + Math.floor(k / own.count)) + (k % own.count)
        const isKnown = ownJoints[k] < joints.length && ownWeights[k] > 0
        indices[at] = isKnown ? ownJoints[k] : 0
        weights[at] = isKnown ? ownWeights[k] : 0
      }
    }
    first += vertices.length
  }
  return { joints, influences, indices, weights }
}

/** Returns the vertices that triangles use, in ascending order, and the corners as indices into this list. */
function usedVertices({ count, indices }: SkinPart): { vertices: Uint32Array; corners: Uint32Array } {
  const corners = new Uint32Array(indices)
  const isUsed = new Uint8Array(count)
  for (let i = 0; i < corners.length; i++) isUsed[corners[i]] = 1
  const newIndex = new Uint32Array(count)
  let total = 0
  for (let vertex = 0; vertex < count; vertex++) {
    newIndex[vertex] = total
    total += isUsed[vertex]
  }
  const vertices = new Uint32Array(total)
  for (let vertex = 0; vertex < count; vertex++) if (isUsed[vertex]) vertices[newIndex[vertex]] = vertex
  for (let i = 0; i < corners.length; i++) corners[i] = corners[i] < count ? newIndex[corners[i]] : NO_VERTEX
  return { vertices, corners }
}

/** Returns whether a matrix has a negative determinant. Such a matrix turns triangles inside out; glTF requires a reversed winding then. */
function isMirroring(m: ArrayLike<number>): boolean {
  const minor = (i: number, j: number) => m[i + 1] * m[j + 2] - m[i + 2] * m[j + 1]
  return m[0] * minor(4, 8) - m[4] * minor(0, 8) + m[8] * minor(0, 4) < 0
}

function reverseWinding(indices: Uint32Array): void {
  for (let i = 0; i + 2 < indices.length; i += 3) {
    const second = indices[i + 1]
    indices[i + 1] = indices[i + 2]
    indices[i + 2] = second
  }
}

/** Multiplies vectors by an affine matrix in place. `w` is 1 for points and 0 for displacements. */
function transform(vectors: Float32Array, m: ArrayLike<number>, w: 0 | 1): void {
  for (let i = 0; i < vectors.length; i += 3) {
    const [x, y, z] = [vectors[i], vectors[i + 1], vectors[i + 2]]
    for (let k = 0; k < 3; k++) vectors[i + k] = m[k] * x + m[4 + k] * y + m[8 + k] * z + m[12 + k] * w
  }
}
