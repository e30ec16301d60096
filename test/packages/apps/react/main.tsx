// Shows one surprised face. `?webgpu` draws on WebGPURenderer, `?gltf` loads by drei's <Gltf>. A click removes the wrinkles.
import { type ComponentType, StrictMode } from 'react'
import { createRoot } from 'react-dom/client'

const ways = import.meta.glob<{ App: ComponentType }>('./ways/*.tsx')
const { App } = await ways[`./ways/${location.search.slice(1) || 'webgl'}.tsx`]!()

createRoot(document.getElementById('root')!).render(
  <StrictMode>
    <App />
  </StrictMode>,
)
