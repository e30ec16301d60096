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

/** Direction and distance from which a camera looks at a face. */
export interface FaceView {
  /** Angle of the camera from the front of the face towards the person's left side, degrees, default 0. */
  yaw?: number
  /** Angle of the camera above the horizon, degrees, default 0. */
  pitch?: number
  /** At 1 (default), the head fills the picture. At values above 1, the camera moves closer to eyes and forehead. */
  zoom?: number
}

/** Fraction of the picture's height, or of its width if the picture is narrow, that the head fills at zoom 1. */
const FILL = 0.9

/** A facing direction within this angle of an axis, in radians, snaps to the axis. Scanned heads are not perfectly symmetric. */
const AXIS_TOLERANCE = Math.PI / 18

/** A mean normal defines the facing direction only if its horizontal length is at least this value. */
const MIN_FRONT = 0.2

const UP = new Vector3(0, 1, 0)

/**
 * Points a camera at a face in its current skeletal pose. The face may have any scale and orientation; +Y is up. For an avatar with a body,
 * frames the head. Ignores blendshapes, so the camera does not depend on the expression.
 *
 * Finds the face as the geometry that blendshapes move. If some meshes have wrinkles, searches only these meshes. Without blendshapes, uses
 * the geometry that a joint named `head` moves, or else the complete object. The facing direction is the mean normal of the geometry that
 * blendshapes move. Fallbacks are the positions of left and right joints, then the +Z axis of `face`, the front in glTF.
 *
 * @param camera camera without a parent. Its `near` and `far` are extended if needed. `fov` and `aspect` of a perspective camera stay
 *   unchanged. The `zoom` of an orthographic camera is set so that the head fits into its frustum.
 * @param face loaded scene, or a mesh.
 * @returns the point that the camera looks at, world space; use it as the target of `OrbitControls`.
 * @throws FurrowError if there are no triangles.
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
  // Eyes and forehead are above the centre of the box, which contains head and neck.
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
 * Returns the distance between camera and head centre at which the head fills the picture. Sets the zoom of an orthographic camera.
 *
 * @param size size of the head's bounding box, whose z axis is the facing direction.
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

/** Updates all world matrices of the scene, because the joints of a mesh may not be descendants of the object. */
function updateWorldMatrices(object: Object3D): void {
  rootOf(object).updateMatrixWorld()
}

/** Returns the rotation about +Y from +Z to the facing direction. */
function turnOf(front: Vector3, face: Object3D, meshes: readonly DrawnMesh[]): Quaternion {
  if (Math.hypot(front.x, front.z) < MIN_FRONT) front.copy(frontOfSides(face, meshes))
  if (Math.hypot(front.x, front.z) < MIN_FRONT) face.getWorldDirection(front)
  const isUpright = Math.hypot(front.x, front.z) >= MIN_FRONT
  const angle = isUpright ? Math.atan2(front.x, front.z) : 0
  const axis = (Math.round(angle / (Math.PI / 2)) * Math.PI) / 2
  return new Quaternion().setFromAxisAngle(UP, Math.abs(angle - axis) < AXIS_TOLERANCE ? axis : angle)
}

/** Returns the bounds of head and neck. Shoulders, which the picture may crop, do not widen the box. */
function headBounds({ meshes, sphere, chin }: HeadRegion, turn: Quaternion): Box3 {
  const all = boundsOf(meshes, turn, (point) => sphere.containsPoint(point))
  const box = boundsOf(meshes, turn, (point) => sphere.containsPoint(point) && point.y >= chin)
  return box.set(box.min.setY(all.min.y), box.max.setY(all.max.y))
}

/** Returns the bounds of the vertices that pass a test, after a rotation that makes the face look along +Z. */
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
    remedy: 'call frameFace after the face is loaded',
  })
}
