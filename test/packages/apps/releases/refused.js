// Loads the shipped face with a plugin on a release of three.js that is too old, and reports the console's messages.

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
