// One surprised face: `?webgpu` draws it on WebGPURenderer, `?gltf` by drei's <Gltf>; a click without its wrinkles.
import { StrictMode } from 'react'
import { createRoot } from 'react-dom/client'

const query = new URLSearchParams(location.search)
const { App } = query.has('webgpu')
  ? await import('./webgpu.tsx')
  : query.has('gltf')
    ? await import('./gltf.tsx')
    : await import('./webgl.tsx')

createRoot(document.getElementById('root')!).render(
  <StrictMode>
    <App />
  </StrictMode>,
)
