import type { WebGLRenderer } from 'three'
import type { Harness } from './harness.ts'

/** Makes a renderer lose its WebGL context, calls `whileLost`, and waits until the context is restored. */
export async function loseContext({ renderer }: Harness, whileLost: () => void) {
  const canvas = renderer.domElement
  const loss = (renderer as WebGLRenderer).getContext().getExtension('WEBGL_lose_context')!
  const once = (event: string) =>
    new Promise((resolve) => canvas.addEventListener(event, resolve, { once: true }))
  const lost = once('webglcontextlost')
  loss.loseContext()
  await lost
  whileLost()
  const restored = once('webglcontextrestored')
  await new Promise((resolve) => setTimeout(resolve, 10))
  loss.restoreContext()
  await restored
}
