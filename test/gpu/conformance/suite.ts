import { beforeEach, expect, it, vi } from 'vitest'
import { type ExpectedPoint, type ExpectedPose, expectedOf, pictureOf, SAMPLES } from './samples.ts'

/** Side of a picture that the square fills, pixels. */
export const PIXELS = 32

const TOLERANCE = 2 / 255

/** Half a step of a byte that stores -1 to 1. */
const ROUNDING = 1 / 255

/** Linear RGBA, rows from the bottom. */
export type Pixels = Float32Array

/** Sample file loaded by an engine. */
export interface OpenedSample {
  readonly isWrinkled: boolean
  /** Sets a pose, draws, and reads the activations. */
  pose(pose: ExpectedPose): Promise<Record<string, number>>
  /**
   * Renders x, y and z of the normals as three pictures, each in all channels. Negative values may appear as 0, and
   * values may be multiplied by the base colour, as under a light along that axis.
   */
  normals(): Promise<{ pictures: readonly Pixels[]; areColoured: boolean }>
  /** Renders the base colour. Ambient light may multiply it by the occlusion. */
  colours(): Promise<{ picture: Pixels; areOccluded: boolean }>
  /** Tells whether roughness at these points is within the tolerance. */
  hasRoughness(points: readonly ExpectedPoint[], tolerance: number): Promise<boolean>
  /** Renders occlusion, if colours do not include it. */
  occlusion?(): Promise<Pixels>
  dispose(): void | Promise<void>
}

/**
 * Tests that an engine produces the expected results of each sample file.
 *
 * @param missing samples that need unsupported features: their faces must stay plain.
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
    const { refused, poses = [] } = expectedOf(name)
    const opened = await open(name)
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
  })

  it.each(missing)('%s stays plain', async (name) => {
    const opened = await open(name)
    expect(opened.isWrinkled).toBe(false)
    await opened.dispose()
  })
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

/** Compares values after clamping negative ones to 0. */
function checkPositive(shown: number, expected: number): void {
  expect(Math.abs(Math.max(0, shown) - Math.max(0, expected))).toBeLessThanOrEqual(TOLERANCE)
}

/** Compares the normals of all pixels. */
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

/** Returns the index of a pixel counted from the top left. */
export function at(column: number, row: number): number {
  return column + (PIXELS - 1 - row) * PIXELS
}
