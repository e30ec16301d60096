import { fileURLToPath } from 'node:url'
import { dropPaths } from '../../scripts/lib/drop-paths.mjs'

const PROBE = fileURLToPath(new URL('probe.js', import.meta.url))
/** Timeout, milliseconds. */
const TIMEOUT = 120_000
/** Time without a frame after which the stage is idle, milliseconds. */
const IDLE_TIME = 400

/** The studio in a browser, driven by mouse and keyboard, and its probe. */
export class StudioPage {
  /** Opens the studio with empty storage. */
  static async open({ browser, origin }) {
    const context = await browser.newContext({
      viewport: { width: 1280, height: 800 },
      reducedMotion: 'reduce',
    })
    const page = await context.newPage()
    page.setDefaultTimeout(TIMEOUT)
    await page.addInitScript({ path: PROBE })
    await page.goto(`${origin}/index.html`)
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

  /** Drops files or folders, and waits until the new face appears. */
  async drop(...files) {
    const before = await this.page.evaluate(() => window.probe.ready.length)
    await dropPaths(this.page, files)
    await this.page.waitForFunction((count) => window.probe.ready.length > count, before)
  }

  /** Drops a project's folder, and starts editing its wrinkles. */
  async openProject(folder) {
    await this.drop(folder)
    await this.button('Edit wrinkles').click()
    await this.button('New area').waitFor()
    await this.waitForIdle()
  }

  /** Waits until automatic wrinkles are done. */
  async waitForWrinkles() {
    await this.page.locator('#areas .row').first().waitFor()
    await this.page.getByText('Making wrinkles').waitFor({ state: 'detached' })
  }

  /** Waits until the stage stops drawing. */
  async waitForIdle() {
    const isIdle = (time) => performance.now() - window.probe.frames.at(-1) > time
    await this.page.waitForFunction(isIdle, IDLE_TIME, { polling: 100 })
  }

  /** Converts fractions of the stage to CSS pixels of the page. */
  async pointAt(x, y) {
    const box = await this.page.locator('#viewport').boundingBox()
    return { x: box.x + x * box.width, y: box.y + y * box.height }
  }

  /** Drags the mouse between two points of the page. */
  async drag(from, to, steps = 12) {
    await this.page.mouse.move(from.x, from.y)
    await this.page.mouse.down()
    await this.page.mouse.move(to.x, to.y, { steps })
    await this.page.mouse.up()
  }

  /** Selects the pointer's mode for lines: Off, Edit or Draw. */
  async linesTo(mode) {
    await this.page.getByRole('group', { name: 'Pointer' }).getByText(mode, { exact: true }).click()
    await this.waitForIdle()
  }

  /**
   * Times from an event to the first frame with changed pixels around a point of the page.
   *
   * @param action triggers the event.
   * @returns milliseconds until the frame was submitted and drawn.
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

  /** Returns the durations of tasks of more than 50 ms during an action, milliseconds. */
  async longTasks(action) {
    const count = await this.page.evaluate(() => window.probe.tasks.length)
    await action()
    await this.waitForIdle()
    return this.page.evaluate((first) => window.probe.tasks.slice(first), count)
  }
}
