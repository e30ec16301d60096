import { Box3, type Object3D, type PerspectiveCamera, Vector3 } from 'three'

/** Camera directions in degrees from +Z, where the face looks. `left` shows the person's left side. */
export const VIEWS = {
  front: { yaw: 0, pitch: 0, zoom: 1 },
  left: { yaw: 90, pitch: 0, zoom: 1 },
  right: { yaw: -90, pitch: 0, zoom: 1 },
  'three-quarter': { yaw: 38, pitch: 4, zoom: 1 },
  close: { yaw: 12, pitch: 3, zoom: 2.1 },
} as const

export type ViewName = keyof typeof VIEWS

/** Vertical field of view in degrees: a portrait lens, which does not enlarge the nose. */
const FIELD_OF_VIEW = 22

/** Fraction of the frame's height that the face fills at zoom 1. */
const FILL = 0.9

/**
 * Positions the camera for a view of a face; returns the point it looks at, for orbit controls.
 *
 * @param face the object to frame, at its current world transform.
 * @param camera with its aspect set.
 */
export function frameView(face: Object3D, camera: PerspectiveCamera, view: ViewName): Vector3 {
  const { yaw, pitch, zoom } = VIEWS[view]
  const box = restBox(face)
  const size = box.getSize(new Vector3())
  const target = box.getCenter(new Vector3())
  // Close views show eyes and forehead, which are above the middle of head and neck.
  if (zoom > 1) target.y += size.y * 0.12
  camera.fov = FIELD_OF_VIEW
  const halfHeight = Math.tan((FIELD_OF_VIEW * Math.PI) / 360)
  const distanceForHeight = size.y / (2 * halfHeight)
  const distanceForWidth = Math.max(size.x, size.z) / (2 * halfHeight * camera.aspect)
  const distance =
    Math.max(distanceForHeight, distanceForWidth) / FILL / zoom + (zoom > 1 ? size.z / 2 : size.z / 4)
  const [theta, phi] = [(yaw * Math.PI) / 180, (pitch * Math.PI) / 180]
  const from = new Vector3(Math.sin(theta) * Math.cos(phi), Math.sin(phi), Math.cos(theta) * Math.cos(phi))
  camera.position.copy(target).addScaledVector(from, distance)
  camera.near = distance / 20
  camera.far = distance * 4
  camera.lookAt(target)
  camera.updateProjectionMatrix()
  return target
}

/** Bounds of the vertices without morph targets, for all of which three.js's own bounding box has room. */
function restBox(face: Object3D): Box3 {
  const box = new Box3()
  face.updateWorldMatrix(true, true)
  face.traverse((object) => {
    const geometry = (object as { geometry?: import('three').BufferGeometry }).geometry
    const position = geometry?.getAttribute('position')
    if (!position) return
    const point = new Vector3()
    for (let i = 0; i < position.count; i++) {
      box.expandByPoint(point.fromBufferAttribute(position, i).applyMatrix4(object.matrixWorld))
    }
  })
  return box
}
