import './component.ts'
import './live-face.ts'
import { PerspectiveCamera, type Scene } from 'three'
import { showFace } from '../show.ts'

document.getElementById('app')!.innerHTML = (await import('./scene.html?raw')).default
if (location.search === '?live') {
  document.querySelector('[wrinkled-model]')!.setAttribute('live-face', 'ws://127.0.0.1:8765/?token=x')
}
const scene = document.querySelector('a-scene') as HTMLElement & {
  object3D: Scene
  camera: PerspectiveCamera
}
// A-Frame's default camera has a parent that user controls rotate, so use another camera.
const camera = new PerspectiveCamera(50, 1)
await showFace(scene.object3D, () => camera)
scene.camera = camera
