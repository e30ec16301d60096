import { type Bone, Box3, type Object3D, type SkinnedMesh, Sphere, Vector3 } from 'three'
import { ALIASES } from '../../drivers/morph/aliases.ts'
import { canonicalTargetName } from '../../drivers/morph/target-names.ts'
import { componentOf, vectorsOf } from '../sources/geometry-arrays.ts'
import type { DrawnMesh } from './drawn-mesh.ts'

/** Fraction of a blendshape's largest displacement above which a vertex counts as moved. */
const MOVED = 0.2

/** Fraction of the blendshapes that may reach beyond a side of the head's bounding box, because a few blendshapes move the body. */
const OUTLIERS = 0.1

/** Radius of the head's sphere, relative to the bounding sphere of the vertices that blendshapes move, or that the head joint moves. */
const HEAD_RADII = { blendshapes: 3, joint: 1.5 }

/** The region of a character's head, in world space. */
export interface HeadRegion {
  /** Meshes that the blendshapes or the head joint move. */
  meshes: DrawnMesh[]
  sphere: Sphere
  /** Height of the chin; -Infinity if unknown. Shoulders below the chin may be wider than the head. */
  chin: number
  /** Mean normal of the surface that blendshapes move: points forwards, length 0 (unknown) to 1 (flat surface). */
  front: Vector3
}

/** Finds the head as the region around the vertices that blendshapes move; undefined if they move no vertex. */
export function headOfBlendshapes(meshes: readonly DrawnMesh[]): HeadRegion | undefined {
  const all = [...new Set(meshes.flatMap(({ mesh }) => Object.keys(mesh.morphTargetDictionary ?? {})))]
  const known = all.filter(isKnown)
  const names = new Set(known.length > 0 ? known : all)
  const boxes = new Map<string, Box3>()
  const total = { normal: new Vector3(), area: 0 }
  const moved = meshes.filter((drawn) => {
    const isMoved = new Uint8Array(drawn.positions.length / 3)
    for (const [name, index] of Object.entries(drawn.mesh.morphTargetDictionary ?? {})) {
      if (!names.has(name)) continue
      const vertices = movedVertices(drawn, index)
      for (const vertex of vertices) isMoved[vertex] = 1
      // A blendshape may move several meshes, e.g. skin, teeth and lashes.
      if (vertices.length > 0) boxes.set(name, boundsOf(drawn, vertices, boxes.get(name)))
    }
    addNormals(drawn, isMoved, total)
    return isMoved.includes(1)
  })
  if (moved.length === 0) return undefined
  const box = commonBox([...boxes.values()])
  const front = total.normal.divideScalar(total.area || 1)
  return { meshes: moved, sphere: sphereOf(box, HEAD_RADII.blendshapes), chin: box.min.y, front }
}

/**
 * Finds the head as the vertices that a head joint or its descendants move. The name of a head joint contains `head`, in upper or
 * lower case, e.g. `mixamorigHead`. Returns undefined if there is no such vertex.
 */
export function headOfJoints(meshes: readonly DrawnMesh[]): HeadRegion | undefined {
  const box = new Box3()
  const moved = meshes.filter((drawn) => {
    const vertices = headVertices(drawn)
    boundsOf(drawn, vertices, box)
    return vertices.length > 0
  })
  if (moved.length === 0) return undefined
  return { meshes: moved, sphere: sphereOf(box, HEAD_RADII.joint), chin: -Infinity, front: new Vector3() }
}

/** Returns the bounding sphere of a box, with its radius scaled. A box of zero size, e.g. around a single vertex, gives an infinite sphere. */
function sphereOf(box: Box3, radii: number): Sphere {
  const sphere = box.getBoundingSphere(new Sphere())
  sphere.radius = radii * sphere.radius || Infinity
  return sphere
}

function boundsOf({ positions }: DrawnMesh, vertices: readonly number[], box = new Box3()): Box3 {
  const point = new Vector3()
  for (const vertex of vertices) box.expandByPoint(point.fromArray(positions, 3 * vertex))
  return box
}

function isKnown(name: string): boolean {
  const canonical = canonicalTargetName(name)
  return ALIASES.some(([first]) => first === canonical)
}

function movedVertices({ mesh, used }: DrawnMesh, index: number): number[] {
  const { attributes, morphAttributes, morphTargetsRelative } = mesh.geometry
  const target = morphAttributes.position?.[index]
  if (!target) return []
  const moved = vectorsOf(target, used)
  const rest = morphTargetsRelative ? null : vectorsOf(attributes.position, used)
  // The loops have no callbacks, because callbacks would take seconds for a million vertices.
  const squares = new Float64Array(used.length)
  let largest = 0
  for (let k = 0; k < used.length; k++) {
    const i = 3 * used[k]
    let [x, y, z] = [moved[i], moved[i + 1], moved[i + 2]]
    if (rest) [x, y, z] = [x - rest[i], y - rest[i + 1], z - rest[i + 2]]
    squares[k] = x * x + y * y + z * z
    largest = Math.max(largest, squares[k])
  }
  const found: number[] = []
  const threshold = MOVED * MOVED * largest
  for (let k = 0; k < used.length; k++) if (squares[k] > threshold) found.push(used[k])
  return found
}

/** Returns a box that contains most of the boxes, see `OUTLIERS`. */
function commonBox(boxes: readonly Box3[]): Box3 {
  const common = new Box3()
  const left = Math.floor(OUTLIERS * boxes.length)
  for (const axis of ['x', 'y', 'z'] as const) {
    const [low, high] = (['min', 'max'] as const).map((end) =>
      boxes.map((box) => box[end][axis]).sort((a, b) => a - b),
    )
    common.min[axis] = low[left]
    common.max[axis] = high[high.length - 1 - left]
  }
  return common
}

/**
 * Adds the area-weighted normals of triangles whose vertices all move. By Stokes' theorem, the sum depends only on the boundary of the
 * surface, so folds of the surface (lids, nostrils, mouth cavity) do not change it.
 */
function addNormals(
  { mesh, positions, triangles }: DrawnMesh,
  isMoved: Uint8Array,
  total: { normal: Vector3; area: number },
): void {
  const [a, b, c] = [new Vector3(), new Vector3(), new Vector3()]
  // Negative scale reverses the winding.
  const side = mesh.matrixWorld.determinant() < 0 ? -0.5 : 0.5
  for (let t = 0; t + 2 < triangles.length; t += 3) {
    const [i, j, k] = [triangles[t], triangles[t + 1], triangles[t + 2]]
    if (!isMoved[i] || !isMoved[j] || !isMoved[k]) continue
    a.fromArray(positions, 3 * i)
    b.fromArray(positions, 3 * j).sub(a)
    c.fromArray(positions, 3 * k).sub(a)
    const normal = b.cross(c).multiplyScalar(side)
    total.normal.add(normal)
    total.area += normal.length()
  }
}

function headVertices({ mesh, used }: DrawnMesh): number[] {
  const { isSkinnedMesh, skeleton, geometry } = mesh as SkinnedMesh
  const { skinIndex, skinWeight } = geometry.attributes
  if (!isSkinnedMesh || !skinIndex || !skinWeight) return []
  const isHead = skeleton.bones.map(isOfHead)
  return used.filter((i) => {
    let weight = 0
    for (let k = 0; k < 4; k++) {
      if (isHead[componentOf(skinIndex, i, k)]) weight += componentOf(skinWeight, i, k)
    }
    return weight > 0.5
  })
}

/** Whether a joint is the head or its descendant. */
export function isOfHead(joint: Object3D): boolean {
  for (let object: Object3D | null = joint; object; object = object.parent) {
    if ((object as Partial<Bone>).isBone && /head/i.test(object.name)) return true
  }
  return false
}
