/** Code that the three.js examples share: a lit face, with controls below it. Not part of the library. */

import * as three from 'three'
import { controls } from './controls.js'

export * from './controls.js'

const { Color, DirectionalLight, HemisphereLight, PerspectiveCamera, Scene } = three

/**
 * Shows a face and draws it every frame.
 *
 * @param {import('three').Object3D} face
 * @param {(seconds: number) => void} [beforeFrame] called before each frame with the seconds since the page was opened.
 * @param {import('three').WebGLRenderer | import('three/webgpu').WebGPURenderer} [renderer] required if the import map
 *   of the page maps `three` to the WebGPU build, which has no `WebGLRenderer`.
 * @returns the scene, camera, renderer and main light, so that a page can change them.
 */
export function showFace(
  face,
  beforeFrame = () => {},
  renderer = new three.WebGLRenderer({ antialias: true }),
) {
  const key = new DirectionalLight('#fff1e4', 3)
  key.position.set(-0.9, 0.9, 0.8)
  const scene = new Scene()
  scene.background = new Color('#d9d6d1')
  scene.add(face, key, new HemisphereLight('#dfe8ff', '#6b5a50', 0.8))
  const camera = new PerspectiveCamera(22, 1, 0.1, 10)
  camera.position.set(0, 0.765, 0.93)
  renderer.setPixelRatio(Math.min(devicePixelRatio, 2))
  document.body.prepend(renderer.domElement)
  const resize = () => {
    const { clientWidth: width } = document.body
    const height = Math.max(240, innerHeight - controls().offsetHeight)
    camera.aspect = width / height
    // Widens the view on narrow pages, so that the whole face fits.
    camera.fov = Math.min(48, 22 / Math.min(1, camera.aspect / 0.8))
    // Keeps the lower edge of the picture 0.584 m above the origin, so that the end of the shirt stays hidden.
    camera.position.y = 0.584 + 0.93 * Math.tan((camera.fov * Math.PI) / 360)
    camera.updateProjectionMatrix()
    renderer.setSize(width, height)
  }
  addEventListener('resize', resize)
  resize()
  renderer.setAnimationLoop((milliseconds) => {
    beforeFrame(milliseconds / 1000)
    renderer.render(scene, camera)
  })
  return { scene, camera, renderer, key }
}

/**
 * Calls a function while the user drags the pointer over a mesh.
 *
 * @param {ReturnType<typeof showFace>} view
 * @param {(hit: { uv: import('three').Vector2, isFirst: boolean }) => void} onHit `isFirst` is true at the first point
 *   of a drag.
 */
export function onDrag({ camera, renderer: { domElement: canvas } }, mesh, onHit) {
  const raycaster = new three.Raycaster()
  const pointer = new three.Vector2()
  const hitAt = ({ offsetX, offsetY }, isFirst) => {
    pointer.set((2 * offsetX) / canvas.clientWidth - 1, 1 - (2 * offsetY) / canvas.clientHeight)
    raycaster.setFromCamera(pointer, camera)
    const [hit] = raycaster.intersectObject(mesh, false)
    if (hit) onHit({ uv: hit.uv, isFirst })
  }
  canvas.style.touchAction = 'none'
  canvas.style.cursor = 'crosshair'
  canvas.addEventListener('pointerdown', (event) => {
    canvas.setPointerCapture(event.pointerId)
    hitAt(event, true)
  })
  canvas.addEventListener('pointermove', (event) => {
    if (event.buttons > 0) hitAt(event, false)
  })
}

/** Sets the weight of a blendshape, 0..1, on all meshes of a face that have this blendshape. */
export function setTarget(face, name, weight) {
  face.traverse(({ morphTargetDictionary: targets, morphTargetInfluences: weights }) => {
    if (targets && name in targets) weights[targets[name]] = weight
  })
}
