import { inject, test } from 'vitest'

/**
 * Whether tests run on WebGPU. A browser without it fails them, except where its project says that it may lack WebGPU:
 * each file then lists one skipped test.
 */
const HAS_WEBGPU = !inject('mayLackWebGPU') || (await navigator.gpu?.requestAdapter()) != null
if (!HAS_WEBGPU) test('all of this on webgpu', ({ skip }) => skip('this browser has no WebGPU'))

/** Rendering paths that are tested in this browser. */
export function available<T extends string>(paths: readonly T[]): readonly T[] {
  return paths.filter((path) => path !== 'webgpu' || HAS_WEBGPU)
}
