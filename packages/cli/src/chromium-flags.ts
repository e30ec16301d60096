import { existsSync } from 'node:fs'

/** Whether Linux has a graphics device at all; elsewhere there always is one. */
const HAS_GPU = process.platform !== 'linux' || existsSync('/dev/dri') || existsSync('/dev/nvidia0')

/**
 * Puts drawing, WebGPU and the browser's own compositor on one Vulkan. A WebGPU canvas hands its pictures over
 * through Vulkan memory; where the compositor cannot take them the GPU process dies ("A valid external Instance
 * reference no longer exists"), so on the software rasteriser all three must be named.
 */
const VULKAN = HAS_GPU
  ? ['--enable-features=Vulkan', '--use-angle=vulkan']
  : ['--enable-features=Vulkan', '--use-angle=swiftshader', '--use-vulkan=swiftshader']

/**
 * Lets a Chromium without a window system draw with WebGL 2 and WebGPU: on a GPU where there is one, else on its
 * software rasteriser.
 */
export const CHROMIUM_FLAGS: readonly string[] = [
  '--no-sandbox',
  '--disable-background-networking',
  '--ignore-gpu-blocklist',
  '--enable-unsafe-swiftshader',
  '--enable-unsafe-webgpu',
  ...(process.platform === 'linux' ? VULKAN : []),
]
