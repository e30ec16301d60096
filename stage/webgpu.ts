/** Code that only stages with `WebGPURenderer` use. They load it when they are created. */

import { PMREMGenerator, type WebGPURenderer } from 'three/webgpu'
import type { EnvironmentGenerator } from './light.ts'

export { Wrinkles } from 'furrow/webgpu'
export { WebGPURenderer } from 'three/webgpu'

export function environmentGenerator(renderer: WebGPURenderer): EnvironmentGenerator {
  return new PMREMGenerator(renderer)
}
