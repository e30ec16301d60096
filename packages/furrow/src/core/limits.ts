/** Maximum number of layers in a wrinkle set. An influence map stores the visibility of each layer in one of its four channels. */
export const MAX_LAYERS = 4

/** Maximum number of areas in a wrinkle set. Every WebGPU and WebGL 2 device supports texture arrays with this many slices. */
export const MAX_AREAS = 256

/** Maximum number of slices in a texture array, guaranteed by every device. */
export const MAX_SLICES = 256

/** Default width and height of packed areas in texels. */
export const DEFAULT_AREA_SIZE = 128

/** Minimum width and height of packed areas in texels. */
export const MIN_AREA_SIZE = 2

/** Maximum width and height of an image in texels, guaranteed by every WebGPU device. */
export const MAX_IMAGE_SIDE = 8192

/** Maximum decoded size of an image or array in bytes: 8192 x 8192 texels in RGBA. */
export const MAX_IMAGE_BYTES = 2 ** 28

/**
 * Maximum decoded size of all wrinkle images in a file, in bytes of RGBA. The limit allows eight images of 4096 x 4096 texels. With
 * mipmaps, these images take 683 MiB on a GPU. Browsers on phones allow 1 to 2 GiB per page.
 */
export const MAX_WRINKLE_BYTES = 2 ** 29

/** Maximum distance that relief moves skin outwards, and that sculpted heights move it in either direction, metres. */
export const MAX_RELIEF = 0.01

/** Maximum number of drivers in a wrinkle set. */
export const MAX_DRIVERS = 4096

/** Maximum number of items in a driver's `links`. */
export const MAX_LINKS = 1024

/** Maximum number of points in a curve. */
export const MAX_CURVE_POINTS = 64

/** Maximum length of a name in a file, in characters. */
export const MAX_NAME_LENGTH = 256

/** Maximum absolute value of weights, scales, amplitudes and coordinates in files. */
export const MAX_NUMBER = 1000

/** Minimum of `1 - onset` in `onsetInfluence`: one byte step. Without this minimum, an onset of 1 would cause a division by zero. */
export const SMALLEST_ONSET_RANGE = 1 / 255
