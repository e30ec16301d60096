import { inject, test } from 'vitest'

/** Whether tests run on WebGPU. In a browser without WebGPU they fail, unless the Vitest project sets `mayLackWebGPU`. */
const HAS_WEBGPU = !inject('mayLackWebGPU') || (await navigator.gpu?.requestAdapter()) != null
if (!HAS_WEBGPU) test('all WebGPU tests of this file', ({ skip }) => skip('this browser has no WebGPU'))

/** Returns the rendering paths to test in this browser. */
export function available<T extends string>(paths: readonly T[]): readonly T[] {
  return paths.filter((path) => path !== 'webgpu' || HAS_WEBGPU)
}
