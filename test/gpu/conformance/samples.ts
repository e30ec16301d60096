/** Reads the sample files of the conformance suite, and their expected results. */

/** Inputs of a pose and expected results. */
export interface ExpectedPose {
  weights?: Record<string, number>
  inputs?: Record<string, number>
  rotations?: Record<string, number[]>
  translations?: Record<string, number[]>
  seconds?: number
  activations: Record<string, number>
  /** Expected values by pixel. Absent if the pose moves the square. */
  points?: ExpectedPoint[]
}

/** Expected values at the centre of a pixel. Columns and rows count from the top left of the square. */
export interface ExpectedPoint {
  column: number
  row: number
  influence: number[]
  normal: number[]
  baseColor: number[]
  roughness: number
  occlusion: number
}

export interface ExpectedSample {
  rule: string
  refused?: true
  poses?: ExpectedPose[]
}

const FOLDER = '../../../conformance/files/'
const models = import.meta.glob('../../../conformance/files/*.glb', {
  query: '?url',
  eager: true,
  import: 'default',
})
const texts = import.meta.glob('../../../conformance/files/*.json', {
  query: '?raw',
  eager: true,
  import: 'default',
})
const pictures = import.meta.glob('../../../conformance/files/*.png', {
  query: '?url',
  eager: true,
  import: 'default',
})

export const SAMPLES = Object.keys(models).map((path) => path.slice(FOLDER.length, -'.glb'.length))

export const addressOf = (name: string) => models[`${FOLDER}${name}.glb`] as string

export const expectedOf = (name: string) =>
  JSON.parse(texts[`${FOLDER}${name}.json`] as string) as ExpectedSample

/** Loads the expected picture of the normals in a pose: 8-bit RGB, rows from the top. */
export async function pictureOf(name: string, pose: number): Promise<ImageData> {
  const response = await fetch(pictures[`${FOLDER}${name}-${pose}.png`] as string)
  const bitmap = await createImageBitmap(await response.blob(), { colorSpaceConversion: 'none' })
  const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d')!
  context.drawImage(bitmap, 0, 0)
  return context.getImageData(0, 0, bitmap.width, bitmap.height)
}
