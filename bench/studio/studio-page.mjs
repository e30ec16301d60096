import { fileURLToPath } from 'node:url'
import { dropPaths } from '../../scripts/lib/drop-paths.mjs'

const PROBE = fileURLToPath(new URL('probe.js', import.meta.url))
/** Milliseconds until what should be seen is given up. */
const PATIENCE = 120_000
/** Milliseconds without a frame after which the stage is at rest. */
const REST = 400

/** The studio in a browser, driven as a person drives it, and what the probe tells of it. */
export class StudioPage {
  /** Opens the studio as a first visitor sees it. */
  static async open({ browser, origin }) {
    const context = await browser.newContext({
      viewport: { width: 1280, height: 800 },
      reducedMotion: 'reduce',
    })
    const page = await context.newPage()
    page.setDefaultTimeout(PATIENCE)
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

  /** Drops files or folders, and waits until another face is shown. */
  async drop(...files) {
    const before = await this.page.evaluate(() => window.probe.ready.length)
    await dropPaths(this.page, files)
    await this.page.waitForFunction((count) => window.probe.ready.length > count, before)
  }

  /** Drops a project's folder, and edits its wrinkles. */
  async openProject(folder) {
    await this.drop(folder)
    await this.button('Edit wrinkles').click()
    await this.button('New area').waitFor()
    await this.untilIdle()
  }

  /** Waits until automatic wrinkles, which have begun, are made. */
  async untilMade() {
    await this.page.locator('#areas .row').first().waitFor()
    await this.page.getByText('Making wrinkles').waitFor({ state: 'detached' })
  }

  /** Waits until nothing is drawn any more. */
  async untilIdle() {
    const isIdle = (rest) => performance.now() - window.probe.frames.at(-1) > rest
    await this.page.waitForFunction(isIdle, REST, { polling: 100 })
  }

  /** A point of the stage, given as fractions of it, in CSS pixels of the page. */
  async pointAt(x, y) {
    const box = await this.page.locator('#viewport').boundingBox()
    return { x: box.x + x * box.width, y: box.y + y * box.height }
  }

  /** Draws with the mouse from one point of the page to another. */
  async drag(from, to, steps = 12) {
    await this.page.mouse.move(from.x, from.y)
    await this.page.mouse.down()
    await this.page.mouse.move(to.x, to.y, { steps })
    await this.page.mouse.up()
  }

  /** Chooses what the pointer does to lines: Off, Edit or Draw. */
  async linesTo(mode) {
    await this.page.getByRole('group', { name: 'Pointer' }).getByText(mode, { exact: true }).click()
    await this.untilIdle()
  }

  /**
   * From an event, which an action causes, to the frame in which pixels round a point of the page are others.
   *
   * @returns milliseconds until its commands had been given, and until it was drawn.
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

  /** The tasks of more than 50 ms during an action, in milliseconds. */
  async longTasks(action) {
    const count = await this.page.evaluate(() => window.probe.tasks.length)
    await action()
    await this.untilIdle()
    return this.page.evaluate((first) => window.probe.tasks.slice(first), count)
  }
}
