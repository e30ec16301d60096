// Shows one surprised face. `?webgpu` draws it on WebGPURenderer, `?gltf` with drei's <Gltf>; a click removes its wrinkles.
import { type ComponentType, StrictMode } from 'react'
import { createRoot } from 'react-dom/client'

const ways = import.meta.glob<{ App: ComponentType }>('./ways/*.tsx')
const { App } = await ways[`./ways/${location.search.slice(1) || 'webgl'}.tsx`]!()

createRoot(document.getElementById('root')!).render(
  <StrictMode>
    <App />
  </StrictMode>,
)
