// Uses `furrow/three` and `furrow/webgpu` with only three.js installed.
import { ExpressionPlayer, WrinkleLoaderPlugin, Wrinkles, wrinklesOf } from 'furrow/three'
import { WrinkleLoaderPlugin as WebgpuLoaderPlugin, Wrinkles as WebgpuWrinkles } from 'furrow/webgpu'
import type { Mesh, Object3D } from 'three'
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'

export async function load(url: string, webgpu: boolean): Promise<Object3D> {
  const Plugin = webgpu ? WebgpuLoaderPlugin : WrinkleLoaderPlugin
  const loader = new GLTFLoader().register((parser) => new Plugin(parser))
  const file = await loader.loadAsync(url)
  new ExpressionPlayer(file.scene, wrinklesOf(file)[0]).play('surprised', 0.4)
  return file.scene
}

export function copy(from: Wrinkles | WebgpuWrinkles, to: Mesh): Wrinkles | WebgpuWrinkles {
  const wrinkles = from instanceof Wrinkles ? new Wrinkles(to, from) : new WebgpuWrinkles(to, from)
  wrinkles.setActivation('nose', 1)
  return wrinkles
}

console.info(JSON.stringify({ classes: [Wrinkles.name, WebgpuWrinkles.name] }))
