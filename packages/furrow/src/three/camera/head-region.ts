import { type Bone, Box3, type Object3D, type SkinnedMesh, Sphere, Vector3 } from 'three'
import { ALIASES } from '../../drivers/morph/aliases.ts'
import { canonicalTargetName } from '../../drivers/morph/target-names.ts'
import { componentOf, vectorsOf } from '../sources/geometry-arrays.ts'
import type { DrawnMesh } from './drawn-mesh.ts'

/** A blendshape moves the vertices that it displaces by more than this fraction of its largest displacement. */
const MOVED = 0.2

/** Fraction of the blendshapes that may reach beyond the box on each side: a few may be of the body. */
const OUTLIERS = 0.1

/** How many times the radius of what blendshapes move, from its centre, the head reaches; and of what a joint moves. */
const HEAD_RADII = { blendshapes: 3, joint: 1.5 }

/** A head in world space. */
export interface HeadRegion {
  /** The meshes that have a part in it. */
  meshes: DrawnMesh[]
  sphere: Sphere
  /** Height of the chin, below which shoulders may be wider than the head; -Infinity if unknown. */
  chin: number
  /** Where the face looks: the mean normal of its surface, whose length is 1 where all triangles look there, and 0 if unknown. */
  front: Vector3
}

/** The head round what the blendshapes of some meshes move; undefined where they move nothing. */
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
      // The same blendshape moves skin, teeth and lashes.
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

/** The head that a joint named `Head`, `mixamorigHead` or the like and those below it move; undefined where there is none. */
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

/** A box of no size, of a blendshape that moves one vertex, tells nothing of the head's. */
function sphereOf(box: Box3, radii: number): Sphere {
  const sphere = box.getBoundingSphere(new Sphere())
  sphere.radius = radii * sphere.radius || Infinity
  return sphere
}

/** Bounds of some vertices, added to those of others. */
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
  // Plain loops: of a million vertices, callbacks take seconds.
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
  const least = MOVED * MOVED * largest
  for (let k = 0; k < used.length; k++) if (squares[k] > least) found.push(used[k])
  return found
}

/** A box that all but a few do not exceed. */
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
 * Adds the normals of triangles whose vertices all move, times their areas. That sum depends on the rim of the surface alone, not on
 * what is folded inside of it, such as lids, nostrils and the inside of the mouth (Stokes' theorem).
 */
function addNormals(
  { mesh, positions, triangles }: DrawnMesh,
  isMoved: Uint8Array,
  total: { normal: Vector3; area: number },
): void {
  const [a, b, c] = [new Vector3(), new Vector3(), new Vector3()]
  // A mirrored mesh is drawn with its triangles turned round.
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

/** Whether a joint is the head or hangs on it. */
export function isOfHead(joint: Object3D): boolean {
  for (let object: Object3D | null = joint; object; object = object.parent) {
    if ((object as Partial<Bone>).isBone && /head/i.test(object.name)) return true
  }
  return false
}
