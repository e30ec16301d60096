import { afterAll, beforeAll, describe, expect, test } from 'vitest'
import { addressOf, EXAMPLES } from '../pages/examples.ts'
import { startStaticServer } from '../pages/static-server.ts'
import { DRIVEN } from './drive/browsers.ts'
import { withHelper } from './page-helper.ts'
import { openWindow } from './window.ts'

const SIZE = [450, 480] as const

let server: Awaited<ReturnType<typeof startStaticServer>>

beforeAll(async () => {
  server = await startStaticServer(undefined, withHelper)
})

afterAll(() => server?.close())

describe.each(DRIVEN)('in %s', (_, kind) => {
  const window = openWindow(kind)

  beforeAll(() => window.resize(...SIZE))

  // Opens the examples that `npm test` opens, and one with Babylon.js. `test/pages` opens all examples in Chromium.
  const opened = EXAMPLES.filter(({ page, quick }) => quick || page === 'babylon')
  test.each(opened.map((example) => [addressOf(example), example.region] as const))(
    'the example %s shows wrinkles',
    async (page, region) => {
      await window.browser.open(`${server.origin}/examples/${page}`)
      await window.until("document.querySelector('canvas')")
      await window.waitForWrinkles(region)
      await window.save(page.replace('.html', '').replace(/[?&]/g, '-'))
    },
  )

  test('the face in inputs.html becomes smooth when a slider is dragged back to 0', async () => {
    await window.browser.open(`${server.origin}/examples/inputs.html?stress=100`)
    await window.until("document.querySelector('canvas')")
    const region = EXAMPLES.find(({ page }) => page === 'inputs')!.region
    const wrinkled = await window.compareWrinkles(region)
    await window.dragSlider(0, 'input[type=range]')
    await window.until("document.querySelector('input').value === '0'")
    const smooth = await window.compareWrinkles(region)
    expect(wrinkled.difference).toBeGreaterThan(20)
    expect(smooth.difference).toBeLessThan(wrinkled.difference / 4)
  })
})
