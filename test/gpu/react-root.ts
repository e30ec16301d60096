import { act, createRoot, extend, type RootState } from '@react-three/fiber'
import { createElement, type ReactNode, StrictMode } from 'react'
import * as THREE from 'three'
import { vi } from 'vitest'
import type { Harness } from './harness.ts'

export interface ReactScene {
  /** Renders elements and a light in StrictMode. */
  show(children: ReactNode): Promise<RootState>
  /** Advances by frames of 0.1 s, which call the frame callbacks of components. */
  advance(frames: number): Promise<void>
  dispose(): Promise<void>
}

/** Creates a React Three Fiber root that uses the renderer of the harness and draws on demand. */
export async function createReactScene(harness: Harness, size: number): Promise<ReactScene> {
  vi.stubGlobal('IS_REACT_ACT_ENVIRONMENT', true)
  extend(THREE as never)
  const root = createRoot(harness.renderer.domElement as HTMLCanvasElement)
  await root.configure({
    gl: harness.renderer as THREE.WebGLRenderer,
    frameloop: 'never',
    size: { width: size, height: size, top: 0, left: 0 },
  })
  let state: RootState | undefined
  let seconds = 0
  return {
    async show(children) {
      const light = createElement('directionalLight', { intensity: 2, position: [1, 1, 1] })
      const store = await act(async () => root.render(createElement(StrictMode, null, light, children)))
      state = store.getState()
      return state
    },
    async advance(frames) {
      for (let i = 0; i < frames; i++) {
        seconds += 0.1
        await act(async () => state!.advance(seconds))
      }
    },
    async dispose() {
      await act(async () => root.unmount())
      vi.unstubAllGlobals()
    },
  }
}
