import { DirectionalLight, Mesh, type Object3D, Scene } from 'three'
import { type GLTF, GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'
import { type Harness, squareCamera } from './harness.ts'

/** Loads a file with wrinkles for the renderer of the harness. */
export function loadFile({ Plugin }: Harness, file: Uint8Array): Promise<GLTF> {
  const loader = new GLTFLoader().register((parser) => new Plugin(parser))
  return loader.parseAsync(file.slice().buffer, '')
}

/** Renders 32 x 32 pixels under one light. Format as in `Harness.render`. */
export function litPicture(harness: Harness, root: Object3D): Promise<Float32Array> {
  const light = new DirectionalLight(0xffffff, 2)
  light.position.set(1, 1, 1)
  return harness.render(new Scene().add(root, light), squareCamera(), 32)
}

/** Creates a mesh that shares geometry and blendshape weights with a loaded one, as React Three Fiber does for JSX made by gltfjsx. */
export function pageMesh(
  { geometry, material: own, morphTargetDictionary }: Mesh,
  morphTargetInfluences: number[],
  material = own,
): Mesh {
  return Object.assign(new Mesh(), { geometry, material, morphTargetDictionary, morphTargetInfluences })
}
