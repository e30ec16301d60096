// Opens the examples that examples.test.ts does not open, and tests further features of some examples.

import type { Page } from 'playwright-core'
import { expect, test } from 'vitest'
import { BROWS, CHEEKS, EXAMPLES } from './examples.ts'
import { savePicture, setControls, useExamples } from './open-example.ts'
import { readNextFrame, SECOND, switchWrinkles } from './paused-page.ts'
import { largestDifference, meanDifference, WHOLE } from './pixels.ts'
import { readCanvas } from './read-canvas.ts'

const { open, testWrinkles } = useExamples()

for (const example of EXAMPLES) if (!example.quick && !example.test) testWrinkles(example)

test('in vrm.html another expression blocks a blink and its wrinkles', () =>
  open('vrm.html?happy=1&blink=1', async (page) => {
    const both = await readCanvas(page)
    expect(largestDifference(both, await setControls(page, { blink: 0 }), WHOLE)).toBe(0)
    const blinking = await setControls(page, { happy: 0, blink: 1 })
    expect(largestDifference(both, blinking, WHOLE)).toBeGreaterThan(20)
    expect(largestDifference(both, await setControls(page, { happy: 1 }), WHOLE)).toBe(0)
  }))

test('expressions.html?scores shows the same face as the blendshapes in the scores', async () => {
  const scored = await open('expressions.html?scores', readCanvas)
  const [rest, played] = await open('expressions.html', async (page) => [
    await readCanvas(page),
    await setControls(page, { surprised: 1 }),
  ])
  expect(largestDifference(scored, rest, BROWS)).toBeGreaterThan(20)
  expect(largestDifference(scored, played, BROWS)).toBeLessThan(largestDifference(scored, rest, BROWS))
})

test('normals.html lights the cheeks with the normals of their blendshapes', () =>
  open('normals.html?remedy=none&cheekPuff=1&mouthPucker=0.7', async (page) => {
    const none = await readCanvas(page)
    const baked = await setControls(page, { baked: true })
    const recomputed = await setControls(page, { recomputed: true })
    await savePicture(recomputed, 'normals.html')
    const cheeks = { left: 0.38, top: 0.35, right: 0.62, bottom: 0.6 }
    // Normals at rest cause a far larger difference than antialiasing.
    expect(largestDifference(none, recomputed, cheeks)).toBeGreaterThan(40)
    // Baked normals differ a little from recomputed ones: those of two blendshapes are only added, and tangents do not rotate.
    expect(meanDifference(baked, recomputed, cheeks)).toBeLessThan(
      meanDifference(none, recomputed, cheeks) / 6,
    )
  }))

test('crowd.html shows faces that wrinkle independently', () =>
  open('crowd.html?count=6', async (page) => {
    const wrinkled = await readCanvas(page)
    await switchWrinkles(page, 'off')
    const smooth = await readNextFrame(page)
    // At any time, four of the six faces wrinkle. These four are in at least two of the four columns.
    const columns = [0, 1, 2, 3].map((i) => ({ left: i / 4, top: 0, right: (i + 1) / 4, bottom: 1 }))
    const changed = columns.filter((column) => largestDifference(wrinkled, smooth, column) > 20)
    expect(changed.length).toBeGreaterThanOrEqual(2)
  }))

/** A stand-in for MediaPipe, whose scores are those of the page. */
const LANDMARKER = `
  export const FilesetResolver = { forVisionTasks: async (folder) => folder }
  export const FaceLandmarker = {
    createFromOptions: async (folder, { baseOptions }) => {
      Object.assign(window, { addresses: [folder, baseOptions.modelAssetPath] })
      return {
        detectForVideo: () => ({
          faceBlendshapes: [{
            categories: Object.entries(window.scores).map(([categoryName, score]) => ({ categoryName, score })),
          }],
        }),
      }
    },
  }`

test('webcam.html calibrates and follows a camera, and sends nothing', () =>
  open('webcam.html?seconds=0', async (page) => {
    const headers = { 'access-control-allow-origin': '*' }
    const requests: string[] = []
    await page.route('https://mediapipe.test/**', (route) => {
      requests.push(`${route.request().method()} ${route.request().url()}`)
      return route.fulfill({ contentType: 'text/javascript', headers, body: LANDMARKER })
    })
    await page.evaluate(`
      window.scores = { browDownLeft: 0.7, browDownRight: 0.7, mouthSmileLeft: 0, mouthSmileRight: 0 }
      navigator.mediaDevices.getUserMedia = async () => new MediaStream()
      HTMLMediaElement.prototype.play = async () => {}`)
    const rest = await readCanvas(page)
    await page.getByLabel('MediaPipe').fill('https://mediapipe.test')
    await page.getByLabel('model').fill('https://mediapipe.test/face.task')
    await page.getByText('camera', { exact: true }).dispatchEvent('click')
    await page.waitForFunction('window.addresses')
    const biased = await settle(page)
    expect(largestDifference(rest, biased, BROWS)).toBeGreaterThan(10)
    expect(await page.evaluate('window.addresses')).toEqual([
      'https://mediapipe.test/wasm',
      'https://mediapipe.test/face.task',
    ])

    await page.getByText('relax', { exact: true }).dispatchEvent('click')
    const relaxed = await settle(page)
    expect(largestDifference(rest, relaxed, BROWS)).toBeLessThan(3)
    await page.evaluate('window.scores.mouthSmileLeft = 1')
    const smiling = await settle(page)
    const [left, right] = [
      { ...CHEEKS, right: 0.5 },
      { ...CHEEKS, left: 0.5 },
    ]
    expect(largestDifference(rest, smiling, left)).toBeGreaterThan(largestDifference(rest, smiling, right))

    await page.getByText('save', { exact: true }).dispatchEvent('click')
    expect(JSON.parse(await page.evaluate('localStorage.calibration')).version).toBe(1)
    expect(requests).toEqual(['GET https://mediapipe.test/vision_bundle.mjs'])
  }))

/** Draws frames three seconds apart, until recordings and transitions have ended. */
async function settle(page: Page) {
  for (let i = 0; i < 3; i++) await page.clock.fastForward(3 * SECOND)
  return readNextFrame(page)
}
