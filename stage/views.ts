import { type FaceView, frameFace } from 'furrow/three'
import { MathUtils, type Object3D, type PerspectiveCamera, type Vector3 } from 'three'

/** Camera views of a face, from where it looks. `left` shows the person's left side. */
export const VIEWS = {
  front: { yaw: 0, pitch: 0, zoom: 1 },
  left: { yaw: 90, pitch: 0, zoom: 1 },
  right: { yaw: -90, pitch: 0, zoom: 1 },
  'three-quarter': { yaw: 38, pitch: 4, zoom: 1 },
  close: { yaw: 12, pitch: 3, zoom: 2.1 },
} as const satisfies Record<string, FaceView>

export type ViewName = keyof typeof VIEWS

/** Vertical field of view in degrees: a portrait lens, which does not enlarge the nose. */
const FIELD_OF_VIEW = 22

/** A face as a camera sees it. */
export interface FramedFace {
  /** The point that the camera looks at, for orbit controls. */
  target: Vector3
  /** Where the face looks: radians round the upright axis from +Z. */
  front: number
}

/**
 * Positions the camera for a view of a face.
 *
 * @param face the object to frame, at its current world transform.
 * @param camera with its aspect set.
 */
export function frameView(
  face: Object3D,
  camera: PerspectiveCamera,
  view: ViewName | Required<FaceView>,
): FramedFace {
  const angles = typeof view === 'string' ? VIEWS[view] : view
  camera.fov = FIELD_OF_VIEW
  const target = frameFace(camera, face, angles)
  // Nothing but the face is on the stage: depth is as precise as it can be.
  const distance = camera.position.distanceTo(target)
  camera.near = distance / 20
  camera.far = distance * 4
  camera.updateProjectionMatrix()
  const { x, z } = camera.position.clone().sub(target)
  return { target, front: Math.atan2(x, z) - MathUtils.degToRad(angles.yaw) }
}
