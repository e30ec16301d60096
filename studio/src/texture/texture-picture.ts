import type { TextureFrame } from '../tools/texture-camera.ts'
import type { TextureLine } from './texture-lines.ts'

const GROUND = '#1b1e22'
const TILE = '#2d3138'
const LINE = '#ffe9c9'
const SHADOW = 'rgb(40 20 10 / 55%)'
const BRUSH = '#e6b48c'

/** Contents of the texture view, from bottom to top. */
export interface TextureLayers {
  /** Colour of the skin with its UV layout, or null if it cannot be drawn. */
  base: CanvasImageSource | null
  area: CanvasImageSource | null
  lines: readonly TextureLine[]
  /** Texture coordinates of the brush outline. */
  outline: readonly (readonly [u: number, v: number])[] | null
}

/** Draws the texture view. @param context canvas context whose units are CSS pixels. */
export function drawTexture(
  context: CanvasRenderingContext2D,
  [width, height]: readonly [number, number],
  { centre, scale }: TextureFrame,
  { base, area, lines, outline }: TextureLayers,
): void {
  const x = (u: number) => (u - centre[0]) * scale + width / 2
  const y = (v: number) => (v - centre[1]) * scale + height / 2
  context.fillStyle = GROUND
  context.fillRect(0, 0, width, height)
  context.fillStyle = TILE
  context.fillRect(x(0), y(0), scale, scale)
  for (const image of [base, area]) if (image) context.drawImage(image, x(0), y(0), scale, scale)
  context.lineJoin = 'round'
  const trace = (points: readonly (readonly [number, number])[]) => {
    for (const [i, [u, v]] of points.entries()) {
      if (i === 0) context.moveTo(x(u), y(v))
      else context.lineTo(x(u), y(v))
    }
  }
  context.beginPath()
  for (const line of lines) for (const piece of line) trace(piece)
  stroke(context, 1.2, LINE)
  if (!outline) return
  context.beginPath()
  trace(outline)
  context.closePath()
  stroke(context, 1.5, BRUSH)
}

/** Draws the current path with a darker border, for contrast on light skin. */
function stroke(context: CanvasRenderingContext2D, width: number, colour: string): void {
  context.lineWidth = width + 1.5
  context.strokeStyle = SHADOW
  context.stroke()
  context.lineWidth = width
  context.strokeStyle = colour
  context.stroke()
}
