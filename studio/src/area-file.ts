import { type Area, type AreaConvention, areaWeights } from 'furrow'
import { decodeImage, toGray } from 'furrow/three'

/**
 * Reads a gray image as an area of influence, named like the file.
 *
 * @throws FurrowError if the file is not an image, or the image is not valid as an area.
 */
export async function readArea(file: File, convention: AreaConvention): Promise<Area> {
  const image = await decodeImage(file, file.name)
  const name = file.name.replace(/\.[^.]+$/, '')
  return { name, weights: areaWeights(toGray(image), convention, file.name) }
}
