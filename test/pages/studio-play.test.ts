/** Tests playing animations of a file and takes of an iPhone in the studio. */

import { readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import type { Page } from 'playwright-core'
import { beforeAll, expect, test } from 'vitest'
import { editGlb } from '../glb.ts'
import { openStudio } from './opened-studio.ts'
import { dropPaths, expectValue, meanPngDifference, shootStage, showSliders, slider } from './studio-page.ts'

const HUMAN = fileURLToPath(new URL('../../faces/human.glb', import.meta.url))
/** Duration of the animation, seconds. */
const DURATION = 2

const studio = openStudio({ width: 1000, height: 560 })
let page: Page

beforeAll(async () => {
  ;({ page } = studio)
  const raised = ['browInnerUp', 'browOuterUpLeft', 'browOuterUpRight']
  writeFileSync(join(studio.folder, 'animated.glb'), animate(readFileSync(HUMAN), raised))
  const header = [
    'Timecode',
    'BlendShapeCount',
    'BrowInnerUp',
    'BrowOuterUpLeft',
    'BrowOuterUpRight',
    'HeadYaw',
  ]
  const rows = Array.from({ length: 61 }, (_, i) => [
    `10:00:0${Math.floor(i / 60)}:${i % 60}`,
    61,
    i,
    i,
    i,
    0,
  ])
  const text = rows.map(([time, count, ...weights]) => [time, count, ...weights.map((w) => Number(w) / 60)])
  writeFileSync(join(studio.folder, 'take.csv'), [header, ...text].map((row) => `${row.join()}\r\n`).join(''))
  writeFileSync(join(studio.folder, 'table.csv'), 'a,b\n1,2\n')
  await dropPaths(page, [join(studio.folder, 'animated.glb')], 'Animated')
  await page.getByRole('slider', { name: /^Divider/ }).press('Home')
})

/** Adds an animation that raises blendshapes from 0 to 1 on every mesh. */
function animate(file: Uint8Array, rising: readonly string[]): Uint8Array {
  return editGlb(file, (json) => {
    const add = (values: number[]) => {
      const bytes = Buffer.from(Float32Array.from(values).buffer)
      const uri = `data:application/octet-stream;base64,${bytes.toString('base64')}`
      const buffer = json.buffers.push({ uri, byteLength: bytes.length }) - 1
      const bufferView = json.bufferViews.push({ buffer, byteLength: bytes.length }) - 1
      const accessor = { bufferView, componentType: 5126, type: 'SCALAR', count: values.length }
      return json.accessors.push(accessor) - 1
    }
    const input = add([0, DURATION])
    Object.assign(json.accessors[input], { min: [0], max: [DURATION] })
    const animation = { name: 'raise', samplers: [] as object[], channels: [] as object[] }
    for (const [node, { mesh }] of json.nodes.entries()) {
      const names: string[] | undefined = json.meshes[mesh]?.extras?.targetNames
      if (!names) continue
      const output = add([...names.map(() => 0), ...names.map((name) => (rising.includes(name) ? 1 : 0))])
      const sampler = animation.samplers.push({ input, output }) - 1
      animation.channels.push({ sampler, target: { node, path: 'weights' } })
    }
    json.animations = [animation]
  })
}

const time = () => slider(page, 'Time (s)')
const forehead = () => slider(page, 'foreheadLeft')
const button = (name: string) => page.getByRole('button', { name, exact: true })
/** Returns the names in a list of animations or takes. */
const clips = (list: string) =>
  page.getByRole('list', { name: list, exact: true }).locator('button span').allTextContents()
const expression = (name: string) => page.locator('#expressions button', { hasText: name })

let rest: Buffer

test('nothing plays by itself, and dragging to a time wrinkles the forehead', async () => {
  await page.getByRole('group', { name: 'Mode' }).getByText('Motion').click()
  await expectValue(time(), 0)
  expect(await button('Play').isVisible()).toBe(true)
  expect(await button('Stop').isDisabled()).toBe(true)
  await expectValue(forehead(), 0)
  rest = await shootStage(page)
  await time().press('End')
  await expectValue(forehead(), 1)
  const raised = await shootStage(page)
  expect(await meanPngDifference(rest, raised)).toBeGreaterThan(0.5)
  // The divider shows the same moving brows with and without wrinkles, so the difference is only the wrinkles.
  const divider = page.getByRole('slider', { name: /^Divider/ })
  await divider.press('End')
  const smooth = await shootStage(page)
  await divider.press('Home')
  expect(await meanPngDifference(smooth, raised)).toBeGreaterThan(0.1)
})

test('stopping restores the previous pose', async () => {
  await button('Stop').click()
  await expectValue(forehead(), 0)
  await expectValue(time(), 0)
  expect(await meanPngDifference(rest, await shootStage(page))).toBe(0)
})

test('plays to the end and pauses by keyboard, and an expression stops it', async () => {
  await page.getByRole('checkbox', { name: 'Loop' }).uncheck()
  await button('Play').focus()
  await page.keyboard.press('Enter')
  await expectValue(forehead(), 1)
  await expectValue(time(), DURATION)
  await button('Play').waitFor()
  await page.getByRole('checkbox', { name: 'Loop' }).check()
  await button('Play').press('Enter')
  await button('Pause').waitFor()
  await expression('Happy').click()
  await button('Play').waitFor()
  expect(await button('Stop').isDisabled()).toBe(true)
  await expectValue(forehead(), 0)
  await expression('Neutral').click()
})

test('a Live Link Face take plays with the same controls', async () => {
  await dropPaths(page, [join(studio.folder, 'take.csv')])
  await page.getByText('Added take to the takes').waitFor()
  expect(await clips('Animations of the file')).toEqual(['raise'])
  expect(await clips('Takes')).toEqual(['take'])
  await time().press('End')
  await expectValue(time(), 1)
  await expectValue(forehead(), 1)
  await showSliders(page)
  await page.locator('#targets summary', { hasText: 'Brows' }).click()
  await slider(page, 'browInnerUp').fill('0.5')
  expect(await button('Stop').isDisabled()).toBe(true)
  await expectValue(slider(page, 'browOuterUpLeft'), 0)
})

test('another table is refused in one line, and the face stays', async () => {
  await dropPaths(page, [join(studio.folder, 'table.csv')])
  await page
    .getByRole('alert')
    .getByText('table.csv cannot be played: its first row has no Timecode')
    .waitFor()
  await page.getByRole('button', { name: 'Dismiss' }).click()
  expect(await clips('Takes')).toEqual(['take'])
})
