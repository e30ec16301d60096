import { expect, it, vi } from 'vitest'
import type { Renderer } from '../../../stage/stage.ts'
import { adapterName } from '../../../studio/src/viewer/adapter.ts'

it('the name of the WebGL adapter is requested only once, because a request waits until the GPU has drawn everything', () => {
  const getParameter = vi.fn(() => 'A graphics adapter')
  const context = { getExtension: () => ({ UNMASKED_RENDERER_WEBGL: 1 }), getParameter }
  const renderer = { isWebGLRenderer: true, getContext: () => context } as unknown as Renderer
  for (let i = 0; i < 3; i++) expect(adapterName(renderer)).toBe('A graphics adapter')
  expect(getParameter).toHaveBeenCalledTimes(1)
})
