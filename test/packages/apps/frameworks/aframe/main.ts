import './component.ts'
import { PerspectiveCamera, type Scene } from 'three'
import { showFace } from '../show.ts'

document.getElementById('app')!.innerHTML = (await import('./scene.html?raw')).default
const scene = document.querySelector('a-scene') as HTMLElement & {
  object3D: Scene
  camera: PerspectiveCamera
}
// A-Frame's own camera has a parent that its controls turn.
const camera = new PerspectiveCamera(50, 1)
await showFace(scene.object3D, () => camera)
scene.camera = camera
