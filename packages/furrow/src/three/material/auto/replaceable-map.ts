import {
  LinearFilter,
  LinearMipmapLinearFilter,
  type Mesh,
  RepeatWrapping,
  type Texture,
  type VideoTexture,
} from 'three'
import type { Size } from '../composed-map.ts'
import { uvLayoutOf } from '../uv-layout.ts'

/** Whether a mesh shows a map as if it repeated, which the layers' maps do. */
export function isRepeated(
  { wrapS, wrapT, channel, offset, repeat, rotation, matrixAutoUpdate }: Texture,
  mesh: Mesh,
): boolean {
  if (wrapS === RepeatWrapping && wrapT === RepeatWrapping) return true
  const isPlaced =
    matrixAutoUpdate && offset.x === 0 && offset.y === 0 && repeat.x === 1 && repeat.y === 1 && rotation === 0
  return isPlaced && wrapS === wrapT && uvLayoutOf(mesh.geometry, channel).isInside
}

/** Whether two maps are shown at the same texture coordinates, and repeat and blur alike. */
export function isSampledAlike(a: Texture, b: Texture): boolean {
  if (a.matrixAutoUpdate) a.updateMatrix()
  if (b.matrixAutoUpdate) b.updateMatrix()
  const isSamePlace = a.channel === b.channel && a.matrix.equals(b.matrix)
  return isSamePlace && a.wrapS === b.wrapS && a.wrapT === b.wrapT && a.anisotropy === b.anisotropy
}

/** Whether a composed map can replace a normal map unseen: it is filtered as those of glTF are by default, and does not change by itself. */
export function isReplaceable(map: Texture): boolean {
  const { width, height } = (map.image ?? {}) as Partial<Size>
  return (
    width! * height! > 0 &&
    map.minFilter === LinearMipmapLinearFilter &&
    map.magFilter === LinearFilter &&
    !map.isRenderTargetTexture &&
    !(map as Partial<VideoTexture>).isVideoTexture
  )
}
