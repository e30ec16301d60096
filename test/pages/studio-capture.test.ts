/** Tests the capture journey of an artist in the studio: connect, calibrate, record, scrub, trim, reload and export. */

import { createSocket } from 'node:dgram'
import { readFileSync } from 'node:fs'
import { WebIO } from '@gltf-transform/core'
import { strFromU8, unzipSync } from 'fflate'
import type { Download, Page } from 'playwright-core'
import { afterAll, beforeAll, expect, test } from 'vitest'
import { type Live, startLive } from '../../packages/cli/src/live/live.ts'
import { ifacialmocapPacket } from '../unit/live/packets.ts'
import { openStudio } from './opened-studio.ts'
import {
  button,
  dismiss,
  eventually,
  expectValue,
  exportFile,
  saveProject,
  showSliders,
  slider,
  undoIs,
  waitUntilReady,
} from './studio-page.ts'

const TOKEN = 'secret'
/** Milliseconds between the packets of the phone. */
const INTERVAL = 100

const studio = openStudio({ width: 1280, height: 800 }, async () => {})
let page: Page
let bridge: Live
let timer: NodeJS.Timeout
/** Scores of the phone, 0..100. The jaw of this person never closes completely. */
const scores = { jawOpen: 20, browInnerUp: 0 }

beforeAll(async () => {
  ;({ page } = studio)
  bridge = await startLive({
    who: 'furrow live',
    host: '127.0.0.1',
    port: 0,
    devices: '127.0.0.1',
    ports: { ifacialmocap: 0 },
    origins: [],
    token: TOKEN,
    onSender: () => {},
  })
  const phone = createSocket('udp4').unref()
  timer = setInterval(
    () => phone.send(ifacialmocapPacket(scores), bridge.ports.ifacialmocap, '127.0.0.1'),
    INTERVAL,
  )
})
afterAll(() => {
  clearInterval(timer)
  bridge.close()
})

const mode = (name: string) =>
  page.getByRole('group', { name: 'Mode' }).getByText(name, { exact: true }).click()
const time = () => slider(page, 'Time (s)')
const names = () =>
  page.getByRole('list', { name: 'Takes', exact: true }).locator('button span').allTextContents()
const status = (text: string) => page.getByRole('status').getByText(text).waitFor()
const number = async (name: string) => Number(await slider(page, name).inputValue())
const textOf = async (download: Download) => readFileSync((await download.path())!)

/** Shows the sliders of brows and jaw. */
async function showWeights(): Promise<void> {
  await showSliders(page)
  for (const group of ['Brows', 'Jaw']) await page.locator('#targets summary', { hasText: group }).click()
}

test('a wrong address is refused in words, and the address of furrow live connects', async () => {
  await showWeights()
  await mode('Motion')
  await page.getByText('Phone or program').click()
  await page.getByLabel('Address').fill('furrow live')
  await button(page, 'Start').click()
  await dismiss(page, 'this is not an address of furrow live')
  await expectValue(slider(page, 'browInnerUp'), 1)

  await page.getByLabel('Address').fill(`ws://127.0.0.1:${bridge.port}/?token=${TOKEN}`)
  await button(page, 'Start').click()
  await status('Connected: iFacialMocap moves the face.')
  await eventually(async () => expect(await number('jawOpen')).toBeGreaterThan(0.1))
  await expectValue(slider(page, 'browInnerUp'), 0)
})

test('calibrating closes the jaw of a relaxed face, with a countdown', async () => {
  await button(page, 'Relax your face (2 s)').click()
  await status('Relax your face: ')
  await page.getByText('Calibrated, and kept in this browser.').waitFor()
  await expectValue(slider(page, 'jawOpen'), 0)
})

test('a recorded take belongs to the project, and stopping restores the pose', async () => {
  await page.locator('#viewport').focus()
  await page.keyboard.press('r')
  await page.getByText(/^Recording: /).waitFor()
  await eventually(async () => expect(await page.getByText(/^Recording: 0:0[1-9]/).count()).toBe(1))
  scores.browInnerUp = 80
  await eventually(async () => expect(await number('browInnerUp')).toBeGreaterThan(0.75))
  await page.locator('#viewport').focus()
  await page.keyboard.press('r')
  await eventually(async () => expect(await names()).toEqual(['Take 1']))
  await undoIs(page, 'Record a take')
  await button(page, 'Stop live').click()
  await expectValue(slider(page, 'browInnerUp'), 1)
})

test('scrubbing shows the recorded pose at each time, and keys set the in and out points', async () => {
  await time().press('End')
  expect(await number('browInnerUp')).toBeGreaterThan(0.75)
  expect(await number('foreheadLeft')).toBeGreaterThan(0.3)
  await time().press('Home')
  expect([await number('browInnerUp'), await number('foreheadLeft')]).toEqual([0, 0])
  await time().fill('0.5')
  await page.keyboard.press('i')
  await undoIs(page, 'Trim a take')
  await button(page, 'Use whole take').click()
  await button(page, 'Use whole take').waitFor({ state: 'detached' })
  await time().fill('0.5')
  await page.keyboard.press('i')
  await page.keyboard.press(' ')
  await button(page, 'Pause').click()
  await button(page, 'Stop').click()
  await expectValue(time(), 0.5)
  await expectValue(slider(page, 'browInnerUp'), 1)
})

test('a take is renamed, deleted, and deleting can be undone', async () => {
  const field = page.getByLabel('Name of Take 1')
  await field.fill('Raise')
  await field.press('Enter')
  await eventually(async () => expect(await names()).toEqual(['Raise']))
  await button(page, 'Delete take').click()
  await eventually(async () => expect(await names()).toEqual([]))
  await button(page, 'Undo').click()
  await eventually(async () => expect(await names()).toEqual(['Raise']))
})

test('takes are kept across a reload, with their in and out points', async () => {
  await page.getByText('Kept in this browser').waitFor()
  await page.reload()
  await waitUntilReady(page)
  await mode('Motion')
  await eventually(async () => expect(await names()).toEqual(['Raise']))
  await expectValue(time(), 0.5)
})

test('takes are saved for other programs, in the project, and as an animation of the exported file', async () => {
  const [csv] = await Promise.all([page.waitForEvent('download'), button(page, 'Save as CSV').click()])
  expect(csv.suggestedFilename()).toBe('Raise.csv')
  const rows = (await textOf(csv))
    .toString()
    .trim()
    .split('\r\n')
    .map((line) => line.split(','))
  const last = Number(rows.at(-1)![rows[0].indexOf('BrowInnerUp')])
  expect(last).toBeGreaterThan(0.75)

  const project = unzipSync(await textOf(await saveProject(page)))
  const take = JSON.parse(strFromU8(project['human/takes/Raise.json']))
  expect(Object.keys(take).sort()).toEqual(['name', 'names', 'range', 'rate', 'version', 'weights'])

  const glb = await textOf(await exportFile(page))
  const [animation, ...others] = (await new WebIO().readBinary(glb)).getRoot().listAnimations()
  expect([animation.getName(), others]).toEqual(['Raise', []])
  const [channel] = animation.listChannels()
  const targets = (channel.getTargetNode()!.getMesh()!.getExtras() as { targetNames: string[] }).targetNames
  const weights = channel.getSampler()!.getOutput()!.getArray()!
  const frames = weights.length / targets.length
  expect(frames).toBe(rows.length - 1)
  expect(weights[(frames - 1) * targets.length + targets.indexOf('browInnerUp')]).toBeCloseTo(last, 4)
})

/** A stand-in for MediaPipe, which reports a smile in each picture. */
const LANDMARKER = `
  export const FilesetResolver = { forVisionTasks: async (folder) => folder }
  export const FaceLandmarker = {
    createFromOptions: async () => ({
      detectForVideo: (video) => ({
        faceBlendshapes: video.videoWidth > 0 ? [{ categories: [{ categoryName: 'jawOpen', score: 0.5 }] }] : [],
      }),
      close: () => {},
    }),
  }`

test('a webcam moves the face, and no picture leaves the page', async () => {
  await showWeights()
  const requests: string[] = []
  await page.route('https://mediapipe.test/**', (route) => {
    requests.push(`${route.request().method()} ${route.request().url()}`)
    const headers = { 'access-control-allow-origin': '*' }
    return route.fulfill({ contentType: 'text/javascript', headers, body: LANDMARKER })
  })
  await page.evaluate(() => {
    const canvas = Object.assign(document.createElement('canvas'), { width: 64, height: 48 })
    const context = canvas.getContext('2d')!
    setInterval(() => context.fillRect(0, 0, 64, 48), 50)
    navigator.mediaDevices.getUserMedia = async () => canvas.captureStream(20)
  })
  await page.getByText('Webcam', { exact: true }).click()
  await page.getByText('Settings of the webcam').click()
  await page.getByLabel('MediaPipe').fill('https://mediapipe.test')
  await page.getByLabel('Model').fill('https://mediapipe.test/face.task')
  await button(page, 'Start').click()
  await status('Connected: the webcam moves the face.')
  await eventually(async () => expect(await number('jawOpen')).toBeGreaterThan(0.4))
  await button(page, 'Happy').click()
  await button(page, 'Start').waitFor()
  expect(requests).toEqual([
    'GET https://mediapipe.test/vision_bundle.mjs',
    'GET https://mediapipe.test/face.task',
  ])
})
