import { beforeEach, expect, it, vi } from 'vitest'
import { type ExpectedPoint, type ExpectedPose, expectedOf, pictureOf, SAMPLES } from './samples.ts'

/** Width and height of a picture, pixels. The sample's square fills it. */
export const PIXELS = 32

const TOLERANCE = 2 / 255

/** Largest rounding error of a byte that stores values from -1 to 1. */
const ROUNDING = 1 / 255

/** Linear RGBA, rows from the bottom. */
export type Pixels = Float32Array

/** Sample file loaded by an engine. */
export interface OpenedSample {
  readonly isWrinkled: boolean
  /** Sets a pose, draws, and reads the activations. */
  pose(pose: ExpectedPose): Promise<Record<string, number>>
  /**
   * Renders x, y and z of the normals as three gray pictures. With `areColoured` the values are multiplied by the base
   * colour. Negative values may be 0, because an engine may show an axis by a light along this axis, and light is not negative.
   */
  normals(): Promise<{ pictures: readonly Pixels[]; areColoured: boolean }>
  /** Renders the base colour. With `areOccluded` it is multiplied by the occlusion, as in ambient light. */
  colours(): Promise<{ picture: Pixels; areOccluded: boolean }>
  /** Tells whether the roughness at all points is within the tolerance. */
  hasRoughness(points: readonly ExpectedPoint[], tolerance: number): Promise<boolean>
  /** Renders the occlusion. Absent if the colours include it. */
  occlusion?(): Promise<Pixels>
  dispose(): void | Promise<void>
}

/**
 * Tests that an engine produces the expected results of each sample file.
 *
 * @param missing names of samples that need unsupported features. Furrow must refuse their wrinkles.
 */
export function testSamples(
  open: (name: string) => Promise<OpenedSample>,
  missing: readonly string[] = [],
): void {
  beforeEach(() => {
    vi.spyOn(console, 'warn').mockImplementation(() => {})
    return () => vi.restoreAllMocks()
  })

  it.each(SAMPLES.filter((name) => !missing.includes(name)))('%s', async (name) => {
    await checkSample(await open(name), name)
  })

  it.each(missing)('%s gets no wrinkles', async (name) => {
    const opened = await open(name)
    expect(opened.isWrinkled).toBe(false)
    await opened.dispose()
  })
}

/** Compares a loaded sample with the expected results, and disposes of it. */
export async function checkSample(opened: OpenedSample, name: string): Promise<void> {
  const { refused, poses = [] } = expectedOf(name)
  expect(opened.isWrinkled).toBe(!refused)
  for (const [i, pose] of poses.entries()) {
    const activations = await opened.pose(pose)
    expect(Object.keys(activations)).toEqual(Object.keys(pose.activations))
    for (const [area, activation] of Object.entries(pose.activations)) {
      expect(Math.abs(activations[area] - activation), area).toBeLessThanOrEqual(1e-6)
    }
    if (pose.points) await checkPoints(opened, pose.points, await pictureOf(name, i))
  }
  await opened.dispose()
}

async function checkPoints(opened: OpenedSample, points: readonly ExpectedPoint[], picture: ImageData) {
  const { pictures, areColoured } = await opened.normals()
  const { picture: colours, areOccluded } = await opened.colours()
  const occlusions = await opened.occlusion?.()
  for (const { column, row, normal, baseColor, occlusion } of points) {
    const pixel = 4 * at(column, row)
    for (const channel of [0, 1, 2]) {
      const colour = areColoured ? baseColor[channel] : 1
      for (const axis of [0, 1, 2]) checkPositive(pictures[axis][pixel + channel], normal[axis] * colour)
      const light = areOccluded ? occlusion : 1
      checkPositive(colours[pixel + channel], baseColor[channel] * light)
    }
    if (occlusions) checkPositive(occlusions[pixel], occlusion)
  }
  const isWhite = points.every(({ baseColor }) => baseColor.every((value) => value === 1))
  if (isWhite || !areColoured) checkPicture(pictures, picture)
  expect(await opened.hasRoughness(points, TOLERANCE)).toBe(true)
}

/** Expects two values to be equal within the tolerance, where negative values count as 0. */
function checkPositive(shown: number, expected: number): void {
  expect(Math.abs(Math.max(0, shown) - Math.max(0, expected))).toBeLessThanOrEqual(TOLERANCE)
}

/** Compares the normals of all pixels with the expected picture. */
function checkPicture(shown: readonly Pixels[], { data }: ImageData): void {
  let worst = 0
  for (const axis of [0, 1, 2]) {
    for (let i = 0; i < PIXELS * PIXELS; i++) {
      const normal = (data[4 * i + axis] / 255) * 2 - 1
      const pixel = shown[axis][4 * at(i % PIXELS, Math.floor(i / PIXELS))]
      worst = Math.max(worst, Math.abs(Math.max(0, pixel) - Math.max(0, normal)))
    }
  }
  expect(worst).toBeLessThanOrEqual(TOLERANCE + ROUNDING)
}

/** Returns the index of a pixel in a picture with rows from the bottom. `column` and `row` count from the top left. */
export function at(column: number, row: number): number {
  return column + (PIXELS - 1 - row) * PIXELS
}
