import { fileURLToPath } from 'node:url'
import { dropPaths } from '../../scripts/lib/drop-paths.mjs'

const PROBE = fileURLToPath(new URL('probe.js', import.meta.url))
/** Timeout of each browser action, milliseconds. */
const TIMEOUT = 120_000
/** The stage, the studio's 3D view, counts as idle after this time without a frame, milliseconds. */
const IDLE_TIME = 400

/** Opens the studio in a browser and controls it with mouse and keyboard. `probe.js` in the page measures response times. */
export class StudioPage {
  /** Opens the studio in a new browser context, so its storage is empty. */
  static async open({ browser, origin }) {
    const context = await browser.newContext({
      viewport: { width: 1280, height: 800 },
      reducedMotion: 'reduce',
    })
    const page = await context.newPage()
    page.setDefaultTimeout(TIMEOUT)
    await page.addInitScript({ path: PROBE })
    await page.goto(`${origin}/index.html?face=human`)
    await page.locator('#stage[aria-busy=false]').waitFor()
    await page.waitForFunction(() => window.probe.frames.length > 0)
    return new StudioPage(page)
  }

  constructor(page) {
    this.page = page
  }

  close() {
    return this.page.context().close()
  }

  button(name) {
    return this.page.getByRole('button', { name, exact: true })
  }

  async drop(...files) {
    const before = await this.page.evaluate(() => window.probe.ready.length)
    await dropPaths(this.page, files)
    await this.page.waitForFunction((count) => window.probe.ready.length > count, before)
  }

  async openProject(folder) {
    await this.drop(folder)
    await this.button('Edit wrinkles').click()
    await this.button('New region').waitFor()
    await this.waitForIdle()
  }

  async waitForWrinkles() {
    await this.page.locator('#areas .row').first().waitFor()
    await this.page.getByText('Making wrinkles').waitFor({ state: 'detached' })
  }

  async waitForIdle() {
    const isIdle = (time) => performance.now() - window.probe.frames.at(-1) > time
    await this.page.waitForFunction(isIdle, IDLE_TIME, { polling: 100 })
  }

  /** Converts fractions of the stage's width and height to CSS pixels of the page. */
  async pointAt(x, y) {
    const box = await this.page.locator('#viewport').boundingBox()
    return { x: box.x + x * box.width, y: box.y + y * box.height }
  }

  async drag(from, to, steps = 12) {
    await this.page.mouse.move(from.x, from.y)
    await this.page.mouse.down()
    await this.page.mouse.move(to.x, to.y, { steps })
    await this.page.mouse.up()
  }

  /** Selects a tool of the toolbar. */
  async chooseTool(name) {
    const toolbar = this.page.getByRole('toolbar', { name: 'Tools' })
    await toolbar.getByRole('button', { name, exact: true }).click()
    await this.waitForIdle()
  }

  /**
   * Runs an action and waits for the first frame in which pixels around a point have changed.
   *
   * @param event type of the event that the action triggers.
   * @param point centre of the watched square, CSS pixels of the page.
   * @param radius half the side of the watched square, CSS pixels.
   * @returns milliseconds from the event until the frame was `submitted`, and until its pixels could be read (`seen`).
   */
  async timeToPixel(event, point, action, radius = 24) {
    const box = await this.page.locator('#viewport').boundingBox()
    const [x, y] = [point.x - box.x - radius, point.y - box.y - radius]
    const rect = { x, y, width: 2 * radius, height: 2 * radius }
    await this.page.evaluate((own) => window.probe.watch(own), rect)
    await action()
    await this.page.waitForFunction(() => window.probe.changed() !== null, null, { polling: 20 })
    return this.page.evaluate((type) => {
      const [{ submitted, seen }, start] = [window.probe.changed(), window.probe.events[type]]
      return { submitted: submitted - start, seen: seen - start }
    }, event)
  }

  /** Runs an action and waits until the stage is idle. Returns the durations, in milliseconds, of main-thread tasks longer than 50 ms. */
  async longTasks(action) {
    const count = await this.page.evaluate(() => window.probe.tasks.length)
    await action()
    await this.waitForIdle()
    return this.page.evaluate((first) => window.probe.tasks.slice(first), count)
  }
}
