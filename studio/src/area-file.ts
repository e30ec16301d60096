import { type Area, type AreaConvention, areaWeights } from 'furrow'
import { decodeImage, toGray } from 'furrow/three'

/**
 * Reads a painted gray image as an area that is named after its file.
 *
 * @throws FurrowError when the file is no image that can be an area.
 */
export async function readArea(file: File, convention: AreaConvention): Promise<Area> {
  const image = await decodeImage(file, file.name)
  const name = file.name.replace(/\.[^.]+$/, '')
  return { name, weights: areaWeights(toGray(image), convention, file.name) }
}
