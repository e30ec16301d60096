// Shared by the apps of all frameworks: waits until the scene contains the face, and points the camera at it. The first click on the page
// raises the brows, the second removes the wrinkles.

import { frameFace, wrinklesOf } from 'furrow/three'
import type { Camera, Mesh, Object3D, PerspectiveCamera } from 'three'

/** Waits for the face, then sets the page's title to the number of areas. */
export async function showFace(scene: Object3D, camera: () => Camera | undefined): Promise<void> {
  let face: Mesh | undefined
  while (!face) {
    await new Promise((resolve) => setTimeout(resolve, 50))
    scene.traverse((node) => {
      const mesh = node as Mesh
      if (mesh.isMesh && wrinklesOf(mesh)) face = mesh
    })
  }
  const wrinkles = wrinklesOf(face)!
  // Shows only the forehead and the eyes, where the wrinkles are.
  frameFace(camera() as PerspectiveCamera, scene, { zoom: 2 })
  let clicks = 0
  document.addEventListener('click', () => {
    if (clicks++ === 0) {
      const { morphTargetDictionary, morphTargetInfluences } = face!
      for (const [name, index] of Object.entries(morphTargetDictionary!)) {
        if (/^brow.*Up/.test(name)) morphTargetInfluences![index] = 1
      }
    } else wrinkles.mode = 'off'
  })
  document.title = `${wrinkles.areaNames.length} areas`
}
