import { type Area, type AreaConvention, areaWeights } from 'furrow'
import { decodeImage, toGray } from 'furrow/three'

/**
 * Reads a painted gray image as an area with the name of its file.
 *
 * @throws FurrowError if the file is not an image or cannot be an area.
 */
export async function readArea(file: File, convention: AreaConvention): Promise<Area> {
  const image = await decodeImage(file, file.name)
  const name = file.name.replace(/\.[^.]+$/, '')
  return { name, weights: areaWeights(toGray(image), convention, file.name) }
}
