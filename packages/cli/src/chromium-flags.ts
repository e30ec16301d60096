import { existsSync } from 'node:fs'

/** Whether there is a graphics device; assumed on systems other than Linux. */
const HAS_GPU = process.platform !== 'linux' || existsSync('/dev/dri') || existsSync('/dev/nvidia0')

/**
 * Makes drawing, WebGPU and the browser's compositor use the same Vulkan. A WebGPU canvas passes its pictures through
 * Vulkan memory; if the compositor cannot read them the GPU process crashes ("A valid external Instance reference no
 * longer exists"). With the software rasteriser all three flags are needed.
 */
const VULKAN = HAS_GPU
  ? // Without a display a device that must show its pictures is none that WebGPU takes: it falls back to the software rasteriser.
    ['--enable-features=Vulkan', '--use-angle=vulkan', '--disable-vulkan-surface']
  : ['--enable-features=Vulkan', '--use-angle=swiftshader', '--use-vulkan=swiftshader']

/**
 * Flags with which a headless Chromium draws with WebGL 2 and WebGPU: on the GPU, or on its software rasteriser where
 * there is none.
 */
export const CHROMIUM_FLAGS: readonly string[] = [
  '--no-sandbox',
  '--disable-background-networking',
  '--ignore-gpu-blocklist',
  '--enable-unsafe-swiftshader',
  '--enable-unsafe-webgpu',
  ...(process.platform === 'linux' ? VULKAN : []),
]
