import { traceStroke, uvOf } from 'furrow/internal'
import type { LayerStroke } from '../document/document.ts'
import type { PaintSkin } from '../paint/paint-skin.ts'
import { TEXTURE_JUMP } from '../tools/texture-camera.ts'

/** Wrinkle line in the texture. UV seams split it into pieces, which are lists of texture coordinates. */
export type TextureLine = readonly (readonly (readonly [u: number, v: number])[])[]

/** Computes wrinkle lines in the texture of a skin, and caches them. */
export class TextureLines {
  readonly #skin: PaintSkin
  readonly #size: number
  readonly #lines = new WeakMap<LayerStroke, TextureLine>()

  /** @param size width and height of the areas, texels. */
  constructor(skin: PaintSkin, size: number) {
    this.#skin = skin
    this.#size = size
  }

  lineOf(stroke: LayerStroke): TextureLine {
    const line = this.#lines.get(stroke) ?? this.#trace(stroke)
    this.#lines.set(stroke, line)
    return line
  }

  #trace(stroke: LayerStroke): TextureLine {
    const skin = { surface: this.#skin.surface, locator: this.#skin.mapOf(this.#size).locator }
    const traced = traceStroke(stroke, skin)
    const pieces: [u: number, v: number][][] = []
    for (let i = 0; i < traced.triangles.length; i++) {
      const [u, v] = uvOf(traced, i, skin)
      const last = pieces.at(-1)?.at(-1)
      if (last && Math.hypot(u - last[0], v - last[1]) < TEXTURE_JUMP) pieces.at(-1)!.push([u, v])
      else pieces.push([[u, v]])
    }
    return pieces.filter((piece) => piece.length > 1)
  }
}
