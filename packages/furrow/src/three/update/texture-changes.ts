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

/** Fraction of a slice above which the GPU generates the mipmaps of all slices faster than the CPU computes and uploads some. */
const LARGE = 0.25

/** Whether three.js can copy rectangles into slices and levels of a texture array; before r173 the complete array is uploaded. */
const COPIES_RECTANGLES = releaseOf(REVISION) >= 173

const changesByTexture = new WeakMap<DataArrayTexture, TextureChanges>()

/** Returns the changes of a texture, shared by all faces that use it. */
export function changesOf(texture: DataArrayTexture): TextureChanges {
  const changes = changesByTexture.get(texture) ?? new TextureChanges(texture)
  changesByTexture.set(texture, changes)
  return changes
}

/**
 * Changed regions of a texture array. Uploads rectangles, because three.js uploads at least complete slices and regenerates all mipmaps.
 * The texture's data stay complete, so three.js can upload them to new renderers, and after a lost context.
 */
export class TextureChanges {
  readonly #texture: DataArrayTexture
  /** Recorded changes, oldest first. */
  readonly #kept: { slice: number; bounds: Bounds }[] = []
  /** Number of changes dropped before `#kept`. */
  #dropped = 0
  /** Number of uploaded changes per renderer. */
  readonly #uploaded = new WeakMap<AnyRenderer, number>()
  readonly #chains = new Map<number, MipChain>()

  constructor(texture: DataArrayTexture) {
    this.#texture = texture
  }

  /** Records a change of the texture's data in a rectangle of a slice. */
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

  /** Uploads the changes that a renderer lacks. */
  upload(renderer: AnyRenderer): void {
    const count = this.#dropped + this.#kept.length
    const from = this.#uploaded.get(renderer) ?? 0
    if (from === count) return
    this.#uploaded.set(renderer, count)
    // Renderers without the texture upload it completely here.
    ;(renderer as WebGLRenderer).initTexture(this.#texture)
    for (const [slice, bounds] of this.#since(from)) this.#copy(renderer as WebGLRenderer, slice, bounds)
  }

  /** Bounding rectangle, per slice, of all changes since the given count. */
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

  /** Copies a rectangle of a slice to the GPU, with the affected texels of smaller levels. */
  #copy(renderer: WebGLRenderer, slice: number, bounds: Bounds): void {
    const texture = this.#texture
    const { levels, touched } = this.#levelsOf(slice, bounds)
    const source = stack(levels, touched, texture)
    const { generateMipmaps } = texture
    // three.js regenerates all mipmaps after a copy to the first level.
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

  /** Levels to upload with their changed rectangles; only the first level if the GPU generates the others. */
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

/** Stacks the rectangles of all levels vertically in one image. */
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
