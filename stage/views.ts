import { type FaceView, frameFace } from 'furrow/three'
import { MathUtils, type Object3D, type PerspectiveCamera, type Vector3 } from 'three'

/** Camera views, relative to the facing direction. `left` shows the person's left side. */
export const VIEWS = {
  front: { yaw: 0, pitch: 0, zoom: 1 },
  left: { yaw: 90, pitch: 0, zoom: 1 },
  right: { yaw: -90, pitch: 0, zoom: 1 },
  'three-quarter': { yaw: 38, pitch: 4, zoom: 1 },
  close: { yaw: 12, pitch: 3, zoom: 2.1 },
} as const satisfies Record<string, FaceView>

export type ViewName = keyof typeof VIEWS

/** Vertical field of view in degrees: a portrait lens, so that the nose is not enlarged. */
const FIELD_OF_VIEW = 22

/** Result of `frameView`. */
export interface FramedFace {
  /** Point that the camera looks at; use it as the target of orbit controls. */
  target: Vector3
  /** Facing direction: radians about +Y, from +Z. */
  front: number
}

/**
 * Positions the camera for a view of a face.
 *
 * @param face object to frame, with its current world transform.
 * @param camera camera with its aspect set.
 */
export function frameView(
  face: Object3D,
  camera: PerspectiveCamera,
  view: ViewName | Required<FaceView>,
): FramedFace {
  const angles = typeof view === 'string' ? VIEWS[view] : view
  camera.fov = FIELD_OF_VIEW
  const target = frameFace(camera, face, angles)
  // Tight depth range for precision: the stage contains only the face.
  const distance = camera.position.distanceTo(target)
  camera.near = distance / 20
  camera.far = distance * 4
  camera.updateProjectionMatrix()
  const { x, z } = camera.position.clone().sub(target)
  return { target, front: Math.atan2(x, z) - MathUtils.degToRad(angles.yaw) }
}
