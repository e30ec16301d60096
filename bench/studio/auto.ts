/** Page that measures how long `furrow/auto` takes to create wrinkles in its web worker, milliseconds. */
import { autoWrinklesInWorker } from 'furrow/auto'
import { type Mesh, Scene } from 'three'
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'
import { skinOf } from '../../packages/furrow/src/auto/character.ts'
import { readMeshes } from '../../packages/furrow/src/three/loader/read-character.ts'

declare global {
  interface Window {
    auto(path: string, size: number): Promise<number>
  }
}

window.auto = async (path, size) => {
  const { scene } = await new GLTFLoader().loadAsync(path)
  new Scene().add(scene)
  const skin = skinOf(readMeshes([findLargest(scene)]))
  const start = performance.now()
  await autoWrinklesInWorker(skin, { size })
  return performance.now() - start
}

function findLargest(scene: Scene['children'][number]): Mesh {
  const meshes: Mesh[] = []
  scene.traverse((object) => {
    if ((object as Mesh).morphTargetInfluences) meshes.push(object as Mesh)
  })
  const count = ({ geometry }: Mesh) => geometry.attributes.position.count
  return meshes.sort((a, b) => count(b) - count(a))[0]
}
