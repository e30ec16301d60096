import type { GrayImage } from 'furrow'
import {
  type FoundSkin,
  type Glb,
  MAP_SLOTS,
  type Pixels,
  partOfImage,
  pixelsOf,
  type WrinkledFile,
  weightsOf,
} from 'furrow-files'
import sharp from 'sharp'
import { escapeMarkup } from '../markup.ts'
import { drawSkinLayout } from '../uv/draw-layout.ts'

/** Width and height of a tile, height of its label, and gap between tiles, pixels. */
const SIDE = 256
const LABEL_HEIGHT = 26
const GAP = 10

const BACKGROUND = '#1b1c1f'

/** Colour (sRGB) and opacity with which areas are drawn over the skin. */
const TINT = [255, 64, 48] as const
const TINT_OPACITY = 0.75

interface Tile {
  label: string
  /** RGB, `SIDE` x `SIDE` pixels. */
  pixels: Uint8Array
}

/** Draws a PNG with one tile per map and per area. Areas are drawn over the base colour of the skin. */
export async function drawSheet(file: WrinkledFile, who: string): Promise<Uint8Array> {
  const skin = await skinOf(file, who)
  const tiles: Tile[] = []
  for (const layer of file.maps.layers) {
    for (const [map, slot] of MAP_SLOTS) {
      const info = layer[slot]
      if (!info) continue
      const part = await partOfImage(file.glb, layer, map, who)
      const pixels = await scaled(part ? { ...part, channels: 1 } : await pixelsOf(file.glb, info, who))
      tiles.push({ label: `${layer.name}: ${map}`, pixels })
    }
  }
  for (const [i, { name, layer }] of file.maps.areas.entries()) {
    const weights = await scaledWeights(await weightsOf(file, i, who))
    const where = file.maps.layers.length > 1 ? ` (${file.maps.layers[layer].name})` : ''
    tiles.push({ label: `${name}${where}`, pixels: tinted(skin, weights) })
  }
  return arrange(tiles)
}

/** Draws a PNG with the base colour and the UV layout of a face without wrinkles. */
export async function drawPlainSheet(glb: Glb, skin: FoundSkin, who: string): Promise<Uint8Array> {
  const rgba = await drawSkinLayout(glb, skin, 2 * SIDE, who)
  const layout = sharp(rgba, { raw: { width: 2 * SIDE, height: 2 * SIDE, channels: 4 } })
  const pixels = await layout.flatten({ background: BACKGROUND }).resize(SIDE, SIDE).raw().toBuffer()
  const layoutTile = { label: `${skin.meshName}: UV layout`, pixels }
  const { material, materialName } = skin
  if (!glb.json.materials?.[material].pbrMetallicRoughness?.baseColorTexture) return arrange([layoutTile])
  const colour = await skinOf({ glb, material }, who)
  return arrange([{ label: `${materialName}: base colour`, pixels: colour }, layoutTile])
}

async function arrange(tiles: readonly Tile[]): Promise<Uint8Array> {
  const columns = Math.ceil(Math.sqrt(tiles.length * 1.3))
  const rows = Math.ceil(tiles.length / columns)
  const width = columns * (SIDE + GAP) + GAP
  const height = rows * (SIDE + LABEL_HEIGHT + GAP) + GAP
  const labels = await Promise.all(tiles.map(({ label }) => renderLabel(label)))
  const parts = tiles.flatMap(({ pixels }, i) => {
    const left = GAP + (i % columns) * (SIDE + GAP)
    const top = GAP + Math.floor(i / columns) * (SIDE + LABEL_HEIGHT + GAP)
    return [
      { input: Buffer.from(pixels), raw: { width: SIDE, height: SIDE, channels: 3 as const }, left, top },
      { input: labels[i], left: left + 2, top: top + SIDE + 5 },
    ]
  })
  return sharp({ create: { width, height, channels: 3, background: BACKGROUND } })
    .composite(parts)
    .removeAlpha()
    .png({ compressionLevel: 9 })
    .toBuffer()
}

function renderLabel(label: string): Promise<Buffer> {
  const plain = label.replaceAll(/\p{C}/gu, ' ').trim() || '?'
  const short = plain.length > 34 ? `${plain.slice(0, 33)}…` : plain
  const text = `<span foreground="#e6e6e6">${escapeMarkup(short)}</span>`
  return sharp({ text: { text, font: 'sans-serif 14', dpi: 72, rgba: true } })
    .resize(SIDE - 4, LABEL_HEIGHT - 6, { fit: 'inside', withoutEnlargement: true })
    .png()
    .toBuffer()
}

/** Returns the base colour of the skin as RGB with `side` x `side` pixels. Without a texture, all pixels are gray. */
export async function skinOf(
  { glb, material }: Pick<WrinkledFile, 'glb' | 'material'>,
  who: string,
  side = SIDE,
): Promise<Uint8Array> {
  const colour = glb.json.materials![material].pbrMetallicRoughness?.baseColorTexture
  return colour ? scaled(await pixelsOf(glb, colour, who), side) : new Uint8Array(3 * side * side).fill(120)
}

/** Scales an image to RGB with `side` x `side` pixels. */
export async function scaled({ width, height, channels, data }: Pixels, side = SIDE): Promise<Uint8Array> {
  const image = sharp(data, { raw: { width, height, channels } }).resize(side, side, { fit: 'fill' })
  return image.toColourspace('srgb').removeAlpha().raw().toBuffer()
}

export async function scaledWeights({ width, height, data }: GrayImage, side = SIDE): Promise<Uint8Array> {
  const image = sharp(data, { raw: { width, height, channels: 1 } }).resize(side, side, { fit: 'fill' })
  return image.toColourspace('b-w').raw().toBuffer()
}

/** Tints an RGB image red, in proportion to the weights of an area. */
export function tinted(skin: Uint8Array, weights: Uint8Array): Uint8Array {
  return skin.map((value, i) => {
    const opacity = (TINT_OPACITY * weights[Math.floor(i / 3)]) / 255
    return Math.round(value * (1 - opacity) + TINT[i % 3] * opacity)
  })
}
