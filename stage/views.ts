import { Box3, type Object3D, type PerspectiveCamera, Vector3 } from 'three'

/** Where the camera stands. `left` shows the person's own left side; the face looks along +Z. */
export const VIEWS = {
  front: { yaw: 0, pitch: 0, zoom: 1 },
  left: { yaw: 90, pitch: 0, zoom: 1 },
  right: { yaw: -90, pitch: 0, zoom: 1 },
  'three-quarter': { yaw: 38, pitch: 4, zoom: 1 },
  close: { yaw: 12, pitch: 3, zoom: 2.1 },
} as const

export type ViewName = keyof typeof VIEWS

/** Vertical field of view in degrees: that of a portrait lens, which does not swell the nose. */
const FIELD_OF_VIEW = 22

/** Share of the frame's height that the face fills at zoom 1. */
const FILL = 0.9

/**
 * Puts the camera in front of a face and returns the point it looks at, for orbit controls.
 *
 * @param face the mesh to frame, as it stands now.
 * @param camera its aspect must be set already.
 */
export function frameView(face: Object3D, camera: PerspectiveCamera, view: ViewName): Vector3 {
  const { yaw, pitch, zoom } = VIEWS[view]
  const box = restBox(face)
  const size = box.getSize(new Vector3())
  const target = box.getCenter(new Vector3())
  // Eyes and forehead are what one looks at; they lie above the middle of head and neck.
  if (zoom > 1) target.y += size.y * 0.12
  camera.fov = FIELD_OF_VIEW
  const half = Math.tan((FIELD_OF_VIEW * Math.PI) / 360)
  const tall = size.y / (2 * half)
  const wide = Math.max(size.x, size.z) / (2 * half * camera.aspect)
  const distance = Math.max(tall, wide) / FILL / zoom + (zoom > 1 ? size.z / 2 : size.z / 4)
  const [a, b] = [(yaw * Math.PI) / 180, (pitch * Math.PI) / 180]
  const from = new Vector3(Math.sin(a) * Math.cos(b), Math.sin(b), Math.cos(a) * Math.cos(b))
  camera.position.copy(target).addScaledVector(from, distance)
  camera.near = distance / 20
  camera.far = distance * 4
  camera.lookAt(target)
  camera.updateProjectionMatrix()
  return target
}

/** Bounds of the face at rest: morph targets would reserve room for every expression at once. */
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
