import { afterAll, afterEach, beforeAll, beforeEach, describe, expect, it, vi } from 'vitest'
import { createHarness, type Harness, RENDERERS } from '../harness.ts'
import { type ExpectedPoint, expectedOf, pictureOf, SAMPLES } from './samples.ts'
import { PIXELS, ThreeRunner, type ThreeSample } from './three-runner.ts'

const TOLERANCE = 2 / 255

/** A picture is rounded to bytes: half a step of a number from -1 to 1. */
const ROUNDING = 1 / 255

it('there are samples', () => {
  expect(SAMPLES.length).toBeGreaterThan(30)
})

describe.each(RENDERERS)('conformance of three.js on %s', (name) => {
  let harness: Harness
  let runner: ThreeRunner
  beforeAll(async () => {
    harness = await createHarness(name)
    runner = new ThreeRunner(harness)
  })
  afterAll(() => {
    runner.dispose()
    harness.dispose()
  })
  beforeEach(() => {
    vi.spyOn(console, 'warn').mockImplementation(() => {})
  })
  afterEach(() => vi.restoreAllMocks())

  it.each(SAMPLES)('%s', async (sample) => {
    const { refused, poses = [] } = expectedOf(sample)
    const opened = await runner.open(sample)
    expect(opened.wrinkles === undefined).toBe(refused === true)
    for (const [i, pose] of poses.entries()) {
      const activations = await opened.pose(pose)
      expect(Object.keys(activations)).toEqual(Object.keys(pose.activations))
      for (const [area, activation] of Object.entries(pose.activations)) {
        expect(Math.abs(activations[area] - activation), area).toBeLessThanOrEqual(1e-6)
      }
      if (!pose.points) continue
      const normals = await opened.normals()
      checkNormals(normals, pose.points)
      if (isWhite(pose.points)) checkPicture(normals, await pictureOf(sample, i))
      const colours = await opened.colours()
      for (const { column, row, baseColor, occlusion } of pose.points) {
        for (const channel of [0, 1, 2]) {
          const shown = colours[4 * at(column, row) + channel]
          expect(Math.abs(shown - baseColor[channel] * occlusion)).toBeLessThanOrEqual(TOLERANCE)
        }
      }
      if (pose.points.some(({ roughness }) => roughness < 1)) await checkRoughness(opened, pose.points)
    }
    opened.dispose()
  })
})

/** The shaded normals of the listed points, in the colour of the material there. */
function checkNormals(shown: readonly Float32Array[], points: readonly ExpectedPoint[]) {
  for (const { column, row, normal, baseColor } of points) {
    for (const axis of [0, 1, 2]) {
      for (const channel of [0, 1, 2]) {
        const expected = Math.max(0, normal[axis]) * baseColor[channel]
        const difference = shown[axis][4 * at(column, row) + channel] - expected
        expect(Math.abs(difference)).toBeLessThanOrEqual(TOLERANCE)
      }
    }
  }
}

function isWhite(points: readonly ExpectedPoint[]): boolean {
  return points.every(({ baseColor }) => baseColor.every((value) => value === 1))
}

/** The shaded normals of all pixels. */
function checkPicture(shown: readonly Float32Array[], { data }: ImageData) {
  let worst = 0
  for (const axis of [0, 1, 2]) {
    for (let i = 0; i < PIXELS * PIXELS; i++) {
      const normal = (data[4 * i + axis] / 255) * 2 - 1
      const pixel = shown[axis][4 * at(i % PIXELS, Math.floor(i / PIXELS))]
      worst = Math.max(worst, Math.abs(pixel - Math.max(0, normal)))
    }
  }
  expect(worst).toBeLessThanOrEqual(TOLERANCE + ROUNDING)
}

/** Highlights, beside those of a plain material that has the roughness of a point everywhere. */
async function checkRoughness(opened: ThreeSample, points: readonly ExpectedPoint[]) {
  const shown = await opened.highlights()
  for (const { column, row, roughness } of points) {
    const plain = await opened.highlights(roughness)
    expect(Math.abs(shown[4 * at(column, row)] - plain[4 * at(column, row)])).toBeLessThanOrEqual(TOLERANCE)
  }
}

/** Index of a pixel, counted from the top left, in a picture whose rows begin at the bottom. */
function at(column: number, row: number): number {
  return column + (PIXELS - 1 - row) * PIXELS
}
