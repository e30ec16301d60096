// Uses `furrow/three` with the oldest supported three.js, whose type declarations lack `three/webgpu`.
import { ExpressionPlayer, frameFace, WrinkleLoaderPlugin, Wrinkles, wrinklesOf } from 'furrow/three'
import type { Mesh, Object3D, PerspectiveCamera } from 'three'
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'

export async function load(url: string, camera: PerspectiveCamera): Promise<Object3D> {
  const loader = new GLTFLoader()
  loader.register((parser) => new WrinkleLoaderPlugin(parser))
  const file = await loader.loadAsync(url)
  new ExpressionPlayer(file.scene, wrinklesOf(file)[0]).play('surprised', 0.4)
  frameFace(camera, file.scene)
  return file.scene
}

export function copy(from: Wrinkles, to: Mesh): Wrinkles {
  const wrinkles = new Wrinkles(to, from)
  wrinkles.setActivation('nose', 1)
  return wrinkles
}

console.info(JSON.stringify({ classes: [Wrinkles.name] }))
