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

  // `capabilities.test.ts` opens auto.html, which makes wrinkles. Only the tests of `pages` can answer requests to esm.sh.
  const opened = EXAMPLES.filter(({ test, cdn }) => !test && !cdn)
  test.each(opened.map((example) => [addressOf(example), example.region] as const))(
    'shows wrinkles in %s',
    async (page, region) => {
      await window.browser.open(`${server.origin}/examples/${page}`)
      await window.until("document.querySelector('canvas')")
      await window.waitForWrinkles(region)
      await window.save(page.replace('.html', '').replace(/[?&]/g, '-'))
    },
  )

  test('smooths the face when a slider of inputs.html is dragged back', async () => {
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
