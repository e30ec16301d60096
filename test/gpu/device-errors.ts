import type { WebGPURenderer } from 'three/webgpu'
import type { Harness } from './harness.ts'

/** Collects the uncaptured errors of the WebGPU device from this call on. Returns a growing list of their messages. */
export function deviceErrors({ renderer }: Harness): string[] {
  const { device } = (renderer as WebGPURenderer).backend as unknown as { device: EventTarget }
  const errors: string[] = []
  device.addEventListener('uncapturederror', (event) => {
    errors.push((event as Event & { error: Error }).error.message)
  })
  return errors
}
