/** Code that the Babylon.js examples share: a lit scene, with controls below it. Not part of the library. */

import { FreeCamera } from '@babylonjs/core/Cameras/freeCamera.js'
import { Engine } from '@babylonjs/core/Engines/engine.js'
import { DirectionalLight } from '@babylonjs/core/Lights/directionalLight.js'
import { HemisphericLight } from '@babylonjs/core/Lights/hemisphericLight.js'
import { Color4 } from '@babylonjs/core/Maths/math.color.js'
import { Vector3 } from '@babylonjs/core/Maths/math.vector.js'
import { Scene } from '@babylonjs/core/scene.js'
import { controls } from './controls.js'

/** Creates a lit scene and draws it every frame. */
export function createScene() {
  const canvas = document.createElement('canvas')
  document.body.prepend(canvas)
  const engine = new Engine(canvas, true)
  const scene = new Scene(engine)
  scene.clearColor = new Color4(0.85, 0.84, 0.82, 1)
  new DirectionalLight('key', new Vector3(0.9, -0.7, -0.8), scene).intensity = 3
  new HemisphericLight('sky', new Vector3(0, 1, 0), scene).intensity = 0.5
  const camera = new FreeCamera('camera', new Vector3(0, 0.765, 0.93), scene)
  camera.setTarget(new Vector3(0, 0.765, 0))
  camera.minZ = 0.1
  const resize = () => {
    const { clientWidth: width } = document.body
    const height = Math.max(240, innerHeight - controls().offsetHeight)
    Object.assign(canvas.style, { width: `${width}px`, height: `${height}px` })
    engine.resize()
    // Widens the view on narrow pages, so that the whole face fits.
    camera.fov = Math.min(0.84, 0.384 / Math.min(1, width / height / 0.8))
    // Raises the camera as the view widens. The picture always ends 0.584 m above the origin, so the lower edge of the shirt stays outside.
    camera.position.y = 0.584 + 0.93 * Math.tan(camera.fov / 2)
  }
  addEventListener('resize', resize)
  engine.runRenderLoop(() => scene.render())
  new ResizeObserver(resize).observe(controls())
  return scene
}
