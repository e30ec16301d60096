import {
  Box3,
  type Object3D,
  type OrthographicCamera,
  type PerspectiveCamera,
  Quaternion,
  Vector3,
} from 'three'
import { FurrowError } from '../../core/error.ts'
import { checkOptionNames } from '../../core/nearest-name.ts'
import { rootOf } from '../mesh/root-of.ts'
import { wrinklesOf } from '../wrinkles-of.ts'
import { type DrawnMesh, drawnMeshes } from './drawn-mesh.ts'
import { type HeadRegion, headOfBlendshapes, headOfJoints } from './head-region.ts'
import { frontOfSides } from './sides.ts'

/** From where a camera sees a face, and how near. */
export interface FaceView {
  /** Degrees from the front to the person's left, 0 by default. */
  yaw?: number
  /** Degrees above the face, 0 by default. */
  pitch?: number
  /** 1 by default: the head fills the picture. Above 1, eyes and forehead are seen from nearer. */
  zoom?: number
}

/** Fraction of the picture's height that the head fills at zoom 1. */
const FILL = 0.9

/** Radians from an axis within which a face looks along it: scans are not quite symmetric. */
const AXIS_TOLERANCE = Math.PI / 18

/** The least horizontal length of a mean normal that tells where a face looks. */
const LEAST_FRONT = 0.2

const UP = new Vector3(0, 1, 0)

/**
 * Points a camera at a face as it is drawn: in the pose of its skeleton, at any scale, wherever it looks; +Y is up. Of an avatar with
 * a body, it frames the head. Blendshapes count as 0, so that every expression has the same picture.
 *
 * The face is what blendshapes move, on the meshes with wrinkles if there are any; without blendshapes, what a joint named `head`
 * moves; otherwise everything. It looks where the skin looks that blendshapes move. Where they move none, the joints of its left and
 * right side say so, in a VRM 0 as in a VRM 1.0; without joints, it looks along `face`'s own +Z axis, as in glTF.
 *
 * @param camera without a parent. Of a perspective camera `fov` and `aspect` are used; of an orthographic one the sides of its frustum,
 *   and `zoom` is set. `near` and `far` are extended where the face needs it.
 * @param face the scene that a loader returned, or a mesh.
 * @returns the point that the camera looks at, in world space: the target of `OrbitControls`.
 * @throws FurrowError when there are no triangles.
 */
export function frameFace(
  camera: PerspectiveCamera | OrthographicCamera,
  face: Object3D,
  view: FaceView = {},
): Vector3 {
  checkOptionNames(view, ['yaw', 'pitch', 'zoom'], 'frameFace')
  const { yaw = 0, pitch = 0, zoom = 1 } = view
  updateWorldMatrices(face)
  const all = drawnMeshes(face)
  const wrinkled = all.filter(({ mesh }) => wrinklesOf(mesh))
  const meshes = wrinkled.length > 0 ? wrinkled : all
  const head = headOfBlendshapes(meshes) ?? headOfJoints(meshes)
  const turn = turnOf(head?.front ?? new Vector3(), face, meshes)
  const box = head ? headBounds(head, turn) : boundsOf(meshes, turn)
  if (box.isEmpty()) throw noTriangles(face)

  const size = box.getSize(new Vector3())
  const target = box.getCenter(new Vector3())
  // Eyes and forehead are above the middle of head and neck.
  if (zoom > 1) target.y += size.y * 0.12
  const distance = fit(camera, size, zoom)
  const [theta, phi] = [(yaw * Math.PI) / 180, (pitch * Math.PI) / 180]
  const from = new Vector3(Math.sin(theta) * Math.cos(phi), Math.sin(phi), Math.cos(theta) * Math.cos(phi))
  target.applyQuaternion(turn)
  camera.position.copy(target).addScaledVector(from.applyQuaternion(turn), distance)
  camera.near = Math.min(camera.near, distance / 20)
  camera.far = Math.max(camera.far, distance * 4)
  camera.lookAt(target)
  camera.updateProjectionMatrix()
  return target
}

/**
 * Sets the zoom of an orthographic camera so that a head fills the picture.
 *
 * @param size of the head; z is towards the camera.
 * @returns the distance of the camera from the middle of the head.
 */
function fit(camera: PerspectiveCamera | OrthographicCamera, size: Vector3, zoom: number): number {
  const width = Math.max(size.x, size.z)
  if ('isOrthographicCamera' in camera) {
    const { left, right, top, bottom } = camera
    const fitting = Math.min((top - bottom) / size.y, (right - left) / width)
    if (Number.isFinite(fitting)) camera.zoom = fitting * FILL * zoom
    return size.length() || 1
  }
  const halfHeight = Math.tan((camera.fov * Math.PI) / 360)
  const distance = Math.max(size.y / (2 * halfHeight), width / (2 * halfHeight * camera.aspect))
  return distance / FILL / zoom + (zoom > 1 ? size.z / 2 : size.z / 4) || 1
}

/** Joints may be outside of the object. */
function updateWorldMatrices(object: Object3D): void {
  rootOf(object).updateMatrixWorld()
}

/** The turn round the upright axis from +Z to where a face looks. */
function turnOf(front: Vector3, face: Object3D, meshes: readonly DrawnMesh[]): Quaternion {
  if (Math.hypot(front.x, front.z) < LEAST_FRONT) front.copy(frontOfSides(face, meshes))
  if (Math.hypot(front.x, front.z) < LEAST_FRONT) face.getWorldDirection(front)
  const isUpright = Math.hypot(front.x, front.z) >= LEAST_FRONT
  const angle = isUpright ? Math.atan2(front.x, front.z) : 0
  const axis = (Math.round(angle / (Math.PI / 2)) * Math.PI) / 2
  return new Quaternion().setFromAxisAngle(UP, Math.abs(angle - axis) < AXIS_TOLERANCE ? axis : angle)
}

/** Bounds of the head and of the neck below it. Shoulders do not count: the picture may cut them off. */
function headBounds({ meshes, sphere, chin }: HeadRegion, turn: Quaternion): Box3 {
  const all = boundsOf(meshes, turn, (point) => sphere.containsPoint(point))
  const box = boundsOf(meshes, turn, (point) => sphere.containsPoint(point) && point.y >= chin)
  return box.set(box.min.setY(all.min.y), box.max.setY(all.max.y))
}

/** Bounds of the vertices that pass a test, turned so that the face looks along +Z. */
function boundsOf(
  meshes: readonly DrawnMesh[],
  turn: Quaternion,
  test: (point: Vector3) => boolean = () => true,
): Box3 {
  const back = turn.clone().invert()
  const box = new Box3()
  const point = new Vector3()
  for (const { positions, used } of meshes) {
    for (const vertex of used) {
      if (test(point.fromArray(positions, 3 * vertex))) box.expandByPoint(point.applyQuaternion(back))
    }
  }
  return box
}

function noTriangles(face: Object3D): FurrowError {
  return new FurrowError({
    who: 'frameFace',
    problem: 'nothing to frame',
    value: face.name,
    limit: 'an object with triangles',
    remedy: 'call it after the face is loaded',
  })
}
