import { existsSync } from 'node:fs'

/** Whether the machine has a GPU. Assumed true on systems other than Linux. */
const HAS_GPU = process.platform !== 'linux' || existsSync('/dev/dri') || existsSync('/dev/nvidia0')

/**
 * Flags that make WebGL, WebGPU and the compositor use the same Vulkan driver. A WebGPU canvas shares Vulkan memory
 * with the compositor. If the compositor cannot read this memory, the GPU process crashes ("A valid external Instance
 * reference no longer exists").
 */
const VULKAN = HAS_GPU
  ? // The last flag lets WebGPU use the GPU without a window surface. Otherwise it would need a display to use the GPU.
    ['--enable-features=Vulkan', '--use-angle=vulkan', '--disable-vulkan-surface']
  : ['--enable-features=Vulkan', '--use-angle=swiftshader', '--use-vulkan=swiftshader']

/** Flags of headless Chromium for WebGL 2 and WebGPU on the GPU. Without a GPU, Chromium uses a software rasteriser. */
export const CHROMIUM_FLAGS: readonly string[] = [
  '--no-sandbox',
  '--disable-background-networking',
  '--ignore-gpu-blocklist',
  '--enable-unsafe-swiftshader',
  '--enable-unsafe-webgpu',
  ...(process.platform === 'linux' ? VULKAN : []),
]
