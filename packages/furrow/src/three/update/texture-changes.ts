import {
  Box2,
  type DataArrayTexture,
  DataTexture,
  type PixelFormat,
  REVISION,
  Vector2,
  Vector3,
  type WebGLRenderer,
} from 'three'
import { type Bounds, widen } from '../../core/bounds.ts'
import type { AnyRenderer } from '../renderer.ts'
import { releaseOf } from '../three-version.ts'
import { channelsOf, firstLevel, MipChain, type MipLevel } from './mip-chain.ts'

/** Maximum number of recorded changes. A renderer that has missed more changes uploads complete slices. */
const MAX_KEPT = 64

/**
 * If a change covers at least this fraction of a slice, the GPU generates the mipmaps of all slices. For smaller changes it is faster to
 * compute the changed texels of the mipmaps on the CPU and upload them.
 */
const LARGE = 0.25

/**
 * Whether three.js can copy a rectangle into a slice and a mipmap level of a texture array. With releases before r173, Furrow uploads the
 * complete array.
 */
const COPIES_RECTANGLES = releaseOf(REVISION) >= 173

const changesByTexture = new WeakMap<DataArrayTexture, TextureChanges>()

/** Returns the changes of a texture, shared by all faces that use it. */
export function changesOf(texture: DataArrayTexture): TextureChanges {
  const changes = changesByTexture.get(texture) ?? new TextureChanges(texture)
  changesByTexture.set(texture, changes)
  return changes
}

/**
 * Records changed rectangles of a texture array, and uploads only these. three.js itself would upload complete slices, and regenerate all
 * mipmaps. The texture's data in CPU memory stay complete, so three.js can upload them to new renderers, and after a lost context.
 */
export class TextureChanges {
  readonly #texture: DataArrayTexture
  /** Recorded changes, oldest first. */
  readonly #kept: { slice: number; bounds: Bounds }[] = []
  /** Number of changes that were removed from `#kept`. */
  #dropped = 0
  /** Number of changes that each renderer has uploaded. */
  readonly #uploaded = new WeakMap<AnyRenderer, number>()
  readonly #chains = new Map<number, MipChain>()

  constructor(texture: DataArrayTexture) {
    this.#texture = texture
  }

  add(slice: number, bounds: Bounds): void {
    if (bounds.x1 <= bounds.x0 || bounds.y1 <= bounds.y0) return
    if (!COPIES_RECTANGLES) {
      this.#texture.needsUpdate = true
      return
    }
    this.#kept.push({ slice, bounds })
    if (this.#kept.length <= MAX_KEPT) return
    this.#kept.shift()
    this.#dropped++
  }

  /** Uploads the changes that a renderer has not uploaded yet. */
  upload(renderer: AnyRenderer): void {
    const count = this.#dropped + this.#kept.length
    const from = this.#uploaded.get(renderer) ?? 0
    if (from === count) return
    this.#uploaded.set(renderer, count)
    // A renderer that does not have the texture uploads it completely here.
    ;(renderer as WebGLRenderer).initTexture(this.#texture)
    for (const [slice, bounds] of this.#since(from)) this.#copy(renderer as WebGLRenderer, slice, bounds)
  }

  /** Returns, for each slice, the bounding rectangle of all changes except the first `from` changes. */
  #since(from: number): Map<number, Bounds> {
    const { width, height, depth } = this.#texture.image as { width: number; height: number; depth: number }
    const rectangles = new Map<number, Bounds>()
    if (from < this.#dropped) {
      for (let slice = 0; slice < depth; slice++)
        rectangles.set(slice, { x0: 0, y0: 0, x1: width, y1: height })
      return rectangles
    }
    for (const { slice, bounds } of this.#kept.slice(from - this.#dropped)) {
      const known = rectangles.get(slice)
      if (known) widen(known, bounds)
      else rectangles.set(slice, { ...bounds })
    }
    return rectangles
  }

  /** Copies a rectangle of a slice, and the affected texels of its mipmaps, to the GPU. */
  #copy(renderer: WebGLRenderer, slice: number, bounds: Bounds): void {
    const texture = this.#texture
    const { levels, touched } = this.#levelsOf(slice, bounds)
    const source = stack(levels, touched, texture)
    const { generateMipmaps } = texture
    // Otherwise three.js would regenerate all mipmaps after a copy to the first level.
    if (levels.length > 1) texture.generateMipmaps = false
    try {
      let row = 0
      for (const [level, { x0, y0, x1, y1 }] of touched.entries()) {
        const region = new Box2(new Vector2(0, row), new Vector2(x1 - x0, row + y1 - y0))
        renderer.copyTextureToTexture(source, texture, region, new Vector3(x0, y0, slice), 0, level)
        row += y1 - y0
      }
    } finally {
      texture.generateMipmaps = generateMipmaps
      source.dispose()
    }
  }

  /** Returns the mipmap levels to upload, and their changed rectangles. Returns only the first level if the GPU generates the other levels. */
  #levelsOf(slice: number, bounds: Bounds): { levels: readonly MipLevel[]; touched: Bounds[] } {
    const first = firstLevel(this.#texture, slice)
    const { x0, y0, x1, y1 } = bounds
    if ((x1 - x0) * (y1 - y0) >= LARGE * first.width * first.height) {
      this.#chains.delete(slice)
      return { levels: [first], touched: [bounds] }
    }
    const chain = this.#chains.get(slice) ?? new MipChain(this.#texture, slice)
    this.#chains.set(slice, chain)
    return { levels: chain.levels, touched: chain.update(bounds) }
  }
}

/** Copies the changed rectangles of all levels into one image, one below the other. */
function stack(levels: readonly MipLevel[], touched: readonly Bounds[], like: DataArrayTexture): DataTexture {
  const channels = channelsOf(levels[0])
  const width = touched[0].x1 - touched[0].x0
  const height = touched.reduce((sum, { y0, y1 }) => sum + y1 - y0, 0)
  const stacked = new Uint8Array(width * height * channels)
  let row = 0
  for (const [level, { x0, y0, x1, y1 }] of touched.entries()) {
    const { data, width: stride } = levels[level]
    for (let y = y0; y < y1; y++) {
      const start = (y * stride + x0) * channels
      stacked.set(data.subarray(start, start + (x1 - x0) * channels), row++ * width * channels)
    }
  }
  const source = new DataTexture(stacked, width, height, like.format as PixelFormat)
  source.colorSpace = like.colorSpace
  source.needsUpdate = true
  return source
}
