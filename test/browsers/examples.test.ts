import { afterAll, beforeAll, describe, expect, test } from 'vitest'
import { CHEEKS_PUFFED, DRIVERS, EXAMPLES, FOREHEAD, PORTRAITS } from '../pages/examples.ts'
import { type Region, WHOLE } from '../pages/pixels.ts'
import { startStaticServer } from '../pages/static-server.ts'
import { DRIVEN } from './drive/browsers.ts'
import { withHelper } from './page-helper.ts'
import { openWindow } from './window.ts'

const SIZE = [450, 480] as const

/** Examples and their wrinkled regions; `null` for an example without wrinkles. */
const PAGES: readonly (readonly [page: string, region: Region | null])[] = [
  ...PORTRAITS.map((page) => [page, FOREHEAD] as const),
  ...DRIVERS.map(([page, driven, , region]) => [`${page}${driven}`, region] as const),
  ['crowd.html?count=6', WHOLE],
  ['tension.html?push=0.3', { left: 0.4, top: 0.3, right: 0.6, bottom: 0.8 }],
  ['vrm.html?happy=1&blink=1', { left: 0.25, top: 0.3, right: 0.75, bottom: 0.7 }],
  [`normals.html?remedy=recomputed&${CHEEKS_PUFFED}`, null],
]

let server: Awaited<ReturnType<typeof startStaticServer>>

beforeAll(async () => {
  server = await startStaticServer(undefined, withHelper)
})

afterAll(() => server?.close())

test('opens every example', () => {
  // `capabilities.test.ts` opens auto.html, which makes wrinkles.
  const opened = new Set(['auto.html', ...PAGES.map(([page]) => page.replace(/\?.*/, ''))])
  expect([...opened].sort()).toEqual([...EXAMPLES].sort())
})

describe.each(DRIVEN)('in %s', (_, kind) => {
  const window = openWindow(kind)

  beforeAll(() => window.resize(...SIZE))

  test.each(PAGES)('shows a face with wrinkles in %s', async (page, region) => {
    await window.browser.open(`${server.origin}/examples/${page}`)
    await window.until("document.querySelector('canvas')")
    if (region) await window.untilWrinkled(region)
    else expect((await window.compareWrinkles(WHOLE)).contrast).toBeGreaterThan(100)
    await window.save(page.replace('.html', '').replace(/[?&]/g, '-'))
  })

  test('smooths the face when a slider of inputs.html is dragged back', async () => {
    await window.browser.open(`${server.origin}/examples/inputs.html?stress=100`)
    await window.until("document.querySelector('canvas')")
    const region = DRIVERS.find(([page]) => page === 'inputs.html')![3]
    const wrinkled = await window.compareWrinkles(region)
    await window.dragSlider(0, 'input[type=range]')
    await window.until("document.querySelector('input').value === '0'")
    const smooth = await window.compareWrinkles(region)
    expect(wrinkled.difference).toBeGreaterThan(20)
    expect(smooth.difference).toBeLessThan(wrinkled.difference / 4)
  })
})
