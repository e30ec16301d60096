/** Maximum number of layers in a set: the influence map has one channel for each. */
export const MAX_LAYERS = 4

/** Maximum number of areas in a set: every WebGPU and WebGL 2 device guarantees this many array layers. */
export const MAX_AREAS = 256

/** Maximum number of slices in a texture array, guaranteed by every device. */
export const MAX_SLICES = 256

/** Default side of packed areas in texels, as in the paper. */
export const DEFAULT_AREA_SIZE = 128

/** Minimum side of packed areas in texels: a single texel has no shape. */
export const MIN_AREA_SIZE = 2

/** Maximum side of an image in texels, guaranteed by every WebGPU device. */
export const MAX_IMAGE_SIDE = 8192

/** Maximum decoded size of an image or array in bytes: 8192 x 8192 texels in RGBA. */
export const MAX_IMAGE_BYTES = 2 ** 28

/**
 * Maximum decoded size of all wrinkle images in a file, in bytes of RGBA: eight images of 4096 x 4096 texels. With mipmaps they take
 * 683 MiB on a GPU; phones allow 1 to 2 GiB per page.
 */
export const MAX_WRINKLE_BYTES = 2 ** 29

/** Maximum number of drivers in a set. */
export const MAX_DRIVERS = 4096

/** Maximum number of links in a driver. */
export const MAX_LINKS = 1024

/** Maximum number of points in a curve. */
export const MAX_CURVE_POINTS = 64

/** Maximum length of a name in a file, in characters. */
export const MAX_NAME_LENGTH = 256

/** Maximum absolute value of weights, scales, amplitudes and coordinates in files. */
export const MAX_NUMBER = 1000
