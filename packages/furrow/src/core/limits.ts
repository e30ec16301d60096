/** Layers a set may hold: one channel each in the influence of a texel. */
export const MAX_LAYERS = 4

/** Areas a set may hold: the array layers that every WebGPU and WebGL 2 device guarantees. */
export const MAX_AREAS = 256

/** Side of the common grid that areas are resampled to; the paper's. */
export const DEFAULT_AREA_SIZE = 128

/** Longest side of an image in texels: the texture size every WebGPU device guarantees. */
export const MAX_IMAGE_SIDE = 8192

/** Most characters of a name in a file. */
export const LONGEST_NAME = 256

/** Largest weight, scale or amplitude that means something. */
export const LARGEST = 1000
