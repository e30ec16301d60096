import type { GrayImage } from 'furrow'
import { copyUvTransform } from 'furrow/internal/three'
import {
  DataTexture,
  LinearFilter,
  LinearMipmapLinearFilter,
  MeshBasicMaterial,
  SRGBColorSpace,
  type Texture,
} from 'three'

/** Onsets of at least this value get the colour `LATE`. Where the depth of a stroke reaches 0, `strokesToOnset` draws this onset. */
const LATEST = 0.5

/** Width of the border of a line, texels, in which scaling a map to twice its size mixes the line's onset with 0. */
const BORDER = 2

/** Colours (sRGB, 0..255) of skin whose onset is 0 (`AT_ONCE`), just above 0 (`EARLY`), and at least `LATEST` (`LATE`). */
const AT_ONCE = [32, 35, 40] as const
const EARLY = [240, 150, 70] as const
const LATE = [60, 120, 220] as const

/**
 * Creates an unlit material that shows an onset map in colours. The texture is freed with the material.
 *
 * @param normalMap normal map of the skin, whose UV channel and transform apply to wrinkles; null if the skin has none.
 */
export function createOnsetMaterial(onset: GrayImage, normalMap: Texture | null): MeshBasicMaterial {
  const { width, height } = onset
  const texture = new DataTexture(onsetColours(onset), width, height)
  texture.colorSpace = SRGBColorSpace
  texture.magFilter = LinearFilter
  texture.minFilter = LinearMipmapLinearFilter
  texture.generateMipmaps = true
  if (normalMap) copyUvTransform(texture, normalMap)
  texture.needsUpdate = true
  const material = new MeshBasicMaterial({ map: texture, toneMapped: false })
  material.addEventListener('dispose', () => texture.dispose())
  return material
}

/** Creates an unlit material for a layer without an onset map. The onset of such a layer is 0 everywhere. */
export function createNoOnsetMaterial(): MeshBasicMaterial {
  const material = new MeshBasicMaterial({ toneMapped: false })
  material.color.setRGB(AT_ONCE[0] / 255, AT_ONCE[1] / 255, AT_ONCE[2] / 255, SRGBColorSpace)
  return material
}

/** Returns the colour of each texel, RGBA. */
export function onsetColours(map: GrayImage): Uint8Array {
  const { data } = map
  const colours = new Uint8Array(4 * data.length)
  for (let i = 0; i < data.length; i++) {
    const onset = unfilteredOnset(map, i)
    const t = Math.min(1, onset / 255 / LATEST)
    for (let k = 0; k < 3; k++) {
      colours[4 * i + k] = onset === 0 ? AT_ONCE[k] : Math.round(EARLY[k] + t * (LATE[k] - EARLY[k]))
    }
    colours[4 * i + 3] = 255
  }
  return colours
}

/**
 * Returns the onset of a texel. If the map was scaled, the onset at the border of a line is mixed with 0, and would look like an early onset.
 * For these texels, returns the largest onset of the texel and of the four texels at a distance of `BORDER`.
 */
function unfilteredOnset({ width, data }: GrayImage, texel: number): number {
  const onset = data[texel]
  const [left, right] = [data[texel - BORDER], data[texel + BORDER]]
  const [above, below] = [data[texel - BORDER * width], data[texel + BORDER * width]]
  const isBorder = onset > 0 && (left === 0 || right === 0 || above === 0 || below === 0)
  return isBorder ? Math.max(onset, left ?? 0, right ?? 0, above ?? 0, below ?? 0) : onset
}
