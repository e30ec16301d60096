import { FurrowError } from 'furrow'
import type { Skin } from 'furrow/author'
import { strainMaps } from 'furrow/internal'
import { type Progress, pixelsOf, type WrinkledFile, weightsOf } from 'furrow-files'
import sharp from 'sharp'
import { scaled, scaledWeights, skinOf, tinted } from '../../inspect/sheet.ts'
import type { PictureRequest } from '../../render/picture.ts'
import { type Picture, renderPictures } from '../../render/render-pictures.ts'
import { changedRect, type Rect } from './changed-rect.ts'
import type { JointPose } from './joint-poses.ts'
import type { Pose } from './poses.ts'
import { colourStrain } from './strain-colours.ts'

export interface ReportImage {
  /** File name in the folder of the report. */
  file: string
  width: number
  height: number
  bytes: Uint8Array
}

// Sizes of images, pixels.
const FACE = { width: 660, height: 880 }
const JOINT = { width: 480, height: 480 }
const STRAIN_SIDE = 512
const AREA_SIDE = 256
const MAX_MAP_SIDE = 1024

export type BeforeAndAfter = readonly [before: ReportImage, after: ReportImage]

/**
 * Draws a face in each pose, without and with wrinkles.
 *
 * @returns two images per pose, or the reason why the face could not be drawn, e.g. because no browser was found.
 */
export async function drawFaces(
  path: string,
  poses: readonly Pose[],
  progress: Progress,
): Promise<BeforeAndAfter[] | string> {
  const requests = poses.flatMap(({ targets }) =>
    (['off', 'default'] as const).map((mode) => ({ input: path, targets, mode, ...FACE })),
  )
  const drawn = await drawnOrReason(requests, progress)
  if (typeof drawn === 'string') return drawn
  const rect = changedRect(
    drawn.map(({ pixels }) => pixels),
    FACE.width,
    FACE.height,
  )
  const images = await Promise.all(
    drawn.map(({ pixels }, i) => {
      const name = `${i % 2 === 0 ? 'before' : 'after'}-${Math.floor(i / 2) + 1}`
      return encode(name, pixels, FACE.width, FACE.height, rect)
    }),
  )
  return poses.map((_, i) => [images[2 * i], images[2 * i + 1]] as const)
}

/** Pictures of a pose of joints. */
export type RestAndBent = readonly [rest: ReportImage, before: ReportImage, after: ReportImage]

/**
 * Draws the areas that joints fold: at rest, bent without wrinkles, and bent with wrinkles.
 *
 * @returns three images per pose, or the reason why the character could not be drawn.
 */
export async function drawJoints(
  path: string,
  poses: readonly JointPose[],
  progress: Progress,
): Promise<RestAndBent[] | string> {
  const requests = poses.flatMap(({ mesh, joints, view }) =>
    [
      { joints: {}, mode: 'default' as const },
      { joints, mode: 'off' as const },
      { joints, mode: 'default' as const },
    ].map((state) => ({ input: path, mesh, view, ...state, ...JOINT })),
  )
  const drawn = await drawnOrReason(requests, progress)
  if (typeof drawn === 'string') return drawn
  const images = await Promise.all(
    drawn.map(({ pixels }, i) => {
      const name = `joint-${['rest', 'before', 'after'][i % 3]}-${Math.floor(i / 3) + 1}`
      return encode(name, pixels, JOINT.width, JOINT.height)
    }),
  )
  return poses.map((_, i) => [images[3 * i], images[3 * i + 1], images[3 * i + 2]] as const)
}

async function drawnOrReason(
  requests: readonly PictureRequest[],
  progress: Progress,
): Promise<Picture[] | string> {
  try {
    return await renderPictures(requests, progress)
  } catch (error) {
    if (error instanceof FurrowError) return error.message
    throw error
  }
}

/** Draws the compression of the skin in UV space, one image per pose. */
export function drawStrain(skin: Skin, poses: readonly Pose[]): Promise<ReportImage[]> {
  const maps = strainMaps(
    skin,
    poses.map(({ targets }) => targets),
    STRAIN_SIDE,
  )
  return Promise.all(maps.map((map, i) => encode(`strain-${i + 1}`, colourStrain(map), STRAIN_SIDE)))
}

/** Draws each area over the base colour of the skin, or over gray if the base colour cannot be read. */
export async function drawAreas(file: WrinkledFile, who: string): Promise<ReportImage[]> {
  const skin = await skinOf(file, who, AREA_SIDE).catch(() =>
    new Uint8Array(3 * AREA_SIDE * AREA_SIDE).fill(120),
  )
  return Promise.all(
    file.maps.areas.map(async (_, i) => {
      const weights = await scaledWeights(await weightsOf(file, i, who), AREA_SIDE)
      return encode(`area-${i + 1}`, tinted(skin, weights), AREA_SIDE)
    }),
  )
}

/** Draws the normal map and the height map of each layer. */
export function drawLayers({ glb, maps }: WrinkledFile, who: string): Promise<ReportImage[][]> {
  return Promise.all(
    maps.layers.map((layer, i) => {
      const slots = [
        ['normal', layer.normalTexture],
        ['height', layer.heightTexture],
      ] as const
      return Promise.all(
        slots.flatMap(([name, texture]) => (texture ? [drawMap(`layer-${i + 1}-${name}`, texture)] : [])),
      )
    }),
  )

  async function drawMap(name: string, texture: Parameters<typeof pixelsOf>[1]): Promise<ReportImage> {
    const pixels = await pixelsOf(glb, texture, who)
    const side = Math.min(MAX_MAP_SIDE, pixels.width)
    return encode(name, await scaled(pixels, side), side)
  }
}

async function encode(
  name: string,
  pixels: Uint8Array,
  width: number,
  height = width,
  rect: Rect = { left: 0, top: 0, width, height },
): Promise<ReportImage> {
  const channels = pixels.length === 3 * width * height ? 3 : 4
  const bytes = await sharp(pixels, { raw: { width, height, channels } })
    .extract(rect)
    .webp({ quality: 90, smartSubsample: true })
    .toBuffer()
  return { file: `${name}.webp`, width: rect.width, height: rect.height, bytes }
}
