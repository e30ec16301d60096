/** Most layers of a set: the influence of a texel has one channel for each. */
export const MAX_LAYERS = 4

/** Most areas of a set: the array layers that every WebGPU and WebGL 2 device guarantees. */
export const MAX_AREAS = 256

/** Most slices of a texture array, for the same reason. */
export const MAX_SLICES = 256

/** Default side, in texels, of the grid that areas are resampled to; the paper's. */
export const DEFAULT_AREA_SIZE = 128

/** Smallest side of that grid: one texel cannot say where wrinkles are. */
export const MIN_AREA_SIZE = 2

/** Longest side of an image in texels: the texture size that every WebGPU device guarantees. */
export const MAX_IMAGE_SIDE = 8192

/** Most bytes of an image or array once it is decoded: those of 8192 x 8192 texels in RGBA. */
export const MAX_IMAGE_BYTES = 2 ** 28

/**
 * Most bytes of all images of a file's wrinkles once they are decoded, in RGBA: eight of 4096 x 4096 texels. With mipmaps that is 683 MiB on
 * a GPU, of the 1 to 2 GiB that phones have for a page.
 */
export const MAX_WRINKLE_BYTES = 2 ** 29

/** Most drivers of a set. */
export const MAX_DRIVERS = 4096

/** Most links of a driver. */
export const MAX_LINKS = 1024

/** Most points of a curve. */
export const MAX_CURVE_POINTS = 64

/** Most characters of a name in a file. */
export const LONGEST_NAME = 256

/** Largest weight, scale or amplitude, and the largest coordinate, that files may hold. */
export const LARGEST = 1000
