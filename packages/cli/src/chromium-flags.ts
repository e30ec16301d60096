import { existsSync } from 'node:fs'

/** Whether the machine has a GPU; assumed true on systems other than Linux. */
const HAS_GPU = process.platform !== 'linux' || existsSync('/dev/dri') || existsSync('/dev/nvidia0')

/**
 * Flags that make WebGL, WebGPU and the compositor use the same Vulkan. A WebGPU canvas shares Vulkan memory with the
 * compositor; if the compositor cannot read it, the GPU process crashes ("A valid external Instance reference no
 * longer exists"). The software rasteriser needs all three flags.
 */
const VULKAN = HAS_GPU
  ? // Without a display, WebGPU rejects devices that need a surface, and falls back to the software rasteriser.
    ['--enable-features=Vulkan', '--use-angle=vulkan', '--disable-vulkan-surface']
  : ['--enable-features=Vulkan', '--use-angle=swiftshader', '--use-vulkan=swiftshader']

/** Flags for WebGL 2 and WebGPU in headless Chromium, on the GPU or, without a GPU, on the software rasteriser. */
export const CHROMIUM_FLAGS: readonly string[] = [
  '--no-sandbox',
  '--disable-background-networking',
  '--ignore-gpu-blocklist',
  '--enable-unsafe-swiftshader',
  '--enable-unsafe-webgpu',
  ...(process.platform === 'linux' ? VULKAN : []),
]
