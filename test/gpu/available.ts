import { inject, test } from 'vitest'

/** Whether tests run on WebGPU. Without WebGPU all tests fail, unless the project may lack it: each file then lists one skipped test. */
const HAS_WEBGPU = !inject('mayLackWebGPU') || (await navigator.gpu?.requestAdapter()) != null
if (!HAS_WEBGPU) test('all WebGPU tests of this file', ({ skip }) => skip('this browser has no WebGPU'))

/** Filters the rendering paths that this browser supports. */
export function available<T extends string>(paths: readonly T[]): readonly T[] {
  return paths.filter((path) => path !== 'webgpu' || HAS_WEBGPU)
}
