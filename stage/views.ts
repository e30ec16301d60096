import { type FaceView, frameFace } from 'furrow/three'
import { MathUtils, type Object3D, type PerspectiveCamera, Vector3 } from 'three'

/** Camera views. Angles are in degrees from the direction in which the face looks. `left` shows the person's left side. */
export const VIEWS = {
  front: { yaw: 0, pitch: 0, zoom: 1 },
  left: { yaw: 90, pitch: 0, zoom: 1 },
  right: { yaw: -90, pitch: 0, zoom: 1 },
  'three-quarter': { yaw: 38, pitch: 4, zoom: 1 },
  close: { yaw: 12, pitch: 3, zoom: 2.1 },
} as const satisfies Record<string, FaceView>

export type ViewName = keyof typeof VIEWS

/** View of one spot of a face. The camera stays as far away as in a view of the whole head, and zooms in. */
export interface CloseUp {
  /** Angles as in `FaceView`, degrees. */
  yaw: number
  pitch: number
  /** Point in the middle of the picture, world space. */
  point: readonly [x: number, y: number, z: number]
  /** Height that the picture shows at the point, in units of the scene. */
  height: number
  /** Rotation of the lights about +Y, degrees. At 0, the lights are the same as in other views. */
  light: number
}

/** Vertical field of view in degrees. It is narrow, because a wide one exaggerates the nose. */
const FIELD_OF_VIEW = 22

export interface FramedFace {
  /** Point that the camera looks at; use it as the target of orbit controls. */
  target: Vector3
  /** Direction in which the face looks: rotation from +Z about +Y, radians. */
  front: number
}

/** Positions the camera for a close-up. `face` and `camera` are as in `frameView`. */
export function frameCloseUp(
  face: Object3D,
  camera: PerspectiveCamera,
  { yaw, pitch, point, height }: CloseUp,
): FramedFace {
  const { target: middle, front } = frameView(face, camera, { yaw, pitch, zoom: 1 })
  const target = new Vector3().fromArray(point)
  camera.position.add(target).sub(middle)
  camera.lookAt(target)
  camera.fov = MathUtils.radToDeg(2 * Math.atan(height / 2 / camera.position.distanceTo(target)))
  camera.updateProjectionMatrix()
  return { target, front }
}

/**
 * Positions the camera for a view of a face.
 *
 * @param face object to frame.
 * @param camera camera; its `aspect` must be set.
 */
export function frameView(
  face: Object3D,
  camera: PerspectiveCamera,
  view: ViewName | Required<FaceView>,
): FramedFace {
  const angles = typeof view === 'string' ? VIEWS[view] : view
  camera.fov = FIELD_OF_VIEW
  const target = frameFace(camera, face, angles)
  // The scene contains only the face, so a narrow depth range suffices and keeps depth precise.
  const distance = camera.position.distanceTo(target)
  camera.near = distance / 20
  camera.far = distance * 4
  camera.updateProjectionMatrix()
  const { x, z } = camera.position.clone().sub(target)
  return { target, front: Math.atan2(x, z) - MathUtils.degToRad(angles.yaw) }
}
