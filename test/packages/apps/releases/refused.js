// Loads the shipped face with the loader plugin on an unsupported release of three.js, and reports the messages on the console.

import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'

export async function refusal(Plugin) {
  const warnings = []
  console.warn = (message) => warnings.push(message)
  const loader = new GLTFLoader().register((parser) => new Plugin(parser))
  const { scene } = await loader.loadAsync('/wrinkled.glb')
  let meshes = 0
  scene.traverse(({ isMesh }) => {
    if (isMesh) meshes++
  })
  window.report = { warnings, meshes }
  document.title = 'done'
}
