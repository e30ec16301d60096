import { FurrowError } from 'furrow'
import { type Skin, strainMaps } from 'furrow/author'
import sharp from 'sharp'
import { type Picture, type Progress, renderPictures } from '../render/render-pictures.ts'
import { weightsOf } from '../wrinkles/inspect.ts'
import { pixelsOf } from '../wrinkles/pixels.ts'
import { scaled, scaledWeights, skinOf, tinted } from '../wrinkles/sheet.ts'
import type { WrinkledFile } from '../wrinkles/wrinkled-file.ts'
import type { ShownPose } from './expressions.ts'
import { movingPart, type Part } from './moving-part.ts'
import { colourStrain } from './strain-colours.ts'

/** An image of the report. */
export interface ReportImage {
  /** Its name in the folder. */
  file: string
  width: number
  height: number
  bytes: Uint8Array
}

/** Sides in pixels. */
const FACE = { width: 660, height: 880 }
const STRAIN = 512
const AREA = 256
const MAP = 1024

/** A pose without and with the wrinkles. */
export type BeforeAndAfter = readonly [before: ReportImage, after: ReportImage]

/**
 * Draws the face of a file in each pose, without and with its wrinkles.
 *
 * @returns a text that says why, where the face cannot be drawn here.
 */
export async function drawFaces(
  path: string,
  poses: readonly ShownPose[],
  progress: Progress,
): Promise<BeforeAndAfter[] | string> {
  const requests = poses.flatMap(({ targets }) =>
    (['off', 'default'] as const).map((mode) => ({ input: path, targets, mode, ...FACE })),
  )
  let drawn: Picture[]
  try {
    drawn = await renderPictures(requests, progress)
  } catch (error) {
    if (error instanceof FurrowError) return error.message
    throw error
  }
  const part = movingPart(
    drawn.map(({ pixels }) => pixels),
    FACE.width,
    FACE.height,
  )
  const images = await Promise.all(
    drawn.map(({ pixels }, i) => {
      const name = `${i % 2 === 0 ? 'before' : 'after'}-${Math.floor(i / 2) + 1}`
      return encode(name, pixels, FACE.width, FACE.height, part)
    }),
  )
  return poses.map((_, i) => [images[2 * i], images[2 * i + 1]] as const)
}

/** What each pose does to the skin, in its texture. */
export function drawStrain(skin: Skin, poses: readonly ShownPose[]): Promise<ReportImage[]> {
  const maps = strainMaps(
    skin,
    poses.map(({ targets }) => targets),
    STRAIN,
  )
  return Promise.all(maps.map((map, i) => encode(`strain-${i + 1}`, colourStrain(map), STRAIN)))
}

/** Where each area lies, over the colour of the skin; over gray where that is no image of the file. */
export async function drawAreas(file: WrinkledFile, who: string): Promise<ReportImage[]> {
  const skin = await skinOf(file, who, AREA).catch(() => new Uint8Array(3 * AREA * AREA).fill(120))
  return Promise.all(
    file.maps.areas.map(async (_, i) => {
      const weights = await scaledWeights(await weightsOf(file, i, who), AREA)
      return encode(`area-${i + 1}`, tinted(skin, weights), AREA)
    }),
  )
}

/** Normal map and relief of each layer. */
export function drawLayers({ glb, maps }: WrinkledFile, who: string): Promise<ReportImage[][]> {
  return Promise.all(
    maps.layers.map((layer, i) => {
      const slots = [
        ['normal', layer.normalTexture],
        ['relief', layer.heightTexture],
      ] as const
      return Promise.all(
        slots.flatMap(([name, texture]) => (texture ? [drawMap(`layer-${i + 1}-${name}`, texture)] : [])),
      )
    }),
  )

  async function drawMap(name: string, texture: Parameters<typeof pixelsOf>[1]): Promise<ReportImage> {
    const pixels = await pixelsOf(glb, texture, who)
    const side = Math.min(MAP, pixels.width)
    return encode(name, await scaled(pixels, side), side)
  }
}

async function encode(
  name: string,
  pixels: Uint8Array,
  width: number,
  height = width,
  part: Part = { left: 0, top: 0, width, height },
): Promise<ReportImage> {
  const channels = pixels.length === 3 * width * height ? 3 : 4
  const bytes = await sharp(pixels, { raw: { width, height, channels } })
    .extract(part)
    .webp({ quality: 90, smartSubsample: true })
    .toBuffer()
  return { file: `${name}.webp`, width: part.width, height: part.height, bytes }
}
