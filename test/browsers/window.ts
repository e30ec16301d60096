import { mkdirSync, writeFileSync } from 'node:fs'
import { afterAll, afterEach, beforeAll, expect, vi } from 'vitest'
import type { Region } from '../pages/pixels.ts'
import type { BrowserKind, DrivenBrowser } from './drive/driven-browser.ts'
import { launch } from './drive/launch.ts'

const OUTPUT = new URL('../output/browsers/', import.meta.url)

/** Time limit and polling interval, milliseconds. The limit is long, because pages draw without a GPU. */
const PATIENCE = { timeout: 300_000, interval: 250 }

/** WebDriver's code for the control key. */
const CONTROL = '\uE009'

/** Arguments of `findElement` in page-helper.js. */
type Names = [selector: string, name?: string, group?: string]

const wordsOf = (names: Names) => names.map((word) => JSON.stringify(word) ?? 'undefined').join()

interface Box {
  x: number
  y: number
  width: number
  height: number
}

type Point = readonly [x: number, y: number]

/** Browser window whose pages contain page-helper.js. */
export class Window {
  browser!: DrivenBrowser

  constructor(readonly name: string) {}

  evaluate<T>(body: string): Promise<T> {
    return this.browser.evaluate(body)
  }

  /**
   * Draws the page's scene with and without wrinkles. Returns the largest difference in a region, and the contrast (maximum minus minimum) of
   * the picture with wrinkles. Both are for the red channel, 0..255.
   */
  compareWrinkles(region: Region): Promise<{ difference: number; contrast: number }> {
    return this.evaluate(`return furrowTest.compareWrinkles(${JSON.stringify(region)})`)
  }

  /** Waits until the picture has contrast and shows wrinkles in a region. Wrinkles may fade in or follow an animation. */
  async waitForWrinkles(region: Region): Promise<void> {
    await vi.waitFor(async () => {
      const { difference, contrast } = await this.compareWrinkles(region)
      expect(contrast).toBeGreaterThan(100)
      expect(difference).toBeGreaterThan(20)
    }, PATIENCE)
  }

  /** Waits until an expression is true on the page. */
  async until(expression: string): Promise<void> {
    await vi.waitFor(async () => {
      expect(await this.evaluate(`return Boolean(${expression})`), expression).toBe(true)
    }, PATIENCE)
  }

  /** Waits for an element, scrolls to it and returns its rectangle in the window. */
  find(...names: Names): Promise<Box> {
    return vi.waitFor(async () => {
      const box = await this.evaluate<Box | null>(`return furrowTest.reachElement(${wordsOf(names)})`)
      expect(box, names.join()).not.toBeNull()
      return box!
    }, PATIENCE)
  }

  async click(...names: Names): Promise<void> {
    const { x, y, width, height } = await this.find(...names)
    await this.drag([[x + width / 2, y + height / 2]])
  }

  /** Clicks a text field and replaces its text. */
  async type(text: string, ...names: Names): Promise<void> {
    await this.click(...names)
    const press = (key: string) => [
      { type: 'keyDown', value: key },
      { type: 'keyUp', value: key },
    ]
    const all = [{ type: 'keyDown', value: CONTROL }, ...press('a'), { type: 'keyUp', value: CONTROL }]
    await this.browser.act([{ type: 'key', id: 'keyboard', actions: [...all, ...[...text].flatMap(press)] }])
  }

  /** Presses the mouse button at the first point, moves to each of the other points, and releases the button. */
  async drag([first, ...others]: readonly Point[]): Promise<void> {
    const move = ([x, y]: Point, duration = 0) => {
      return { type: 'pointerMove', duration, x: Math.round(x), y: Math.round(y) }
    }
    const actions = [
      move(first!),
      { type: 'pointerDown', button: 0 },
      ...others.map((point) => move(point, 60)),
      { type: 'pointerUp', button: 0 },
    ]
    await this.browser.act([{ type: 'pointer', id: 'mouse', parameters: { pointerType: 'mouse' }, actions }])
  }

  /** Drags the handle of a horizontal slider to its left end (0) or its right end (1). */
  async dragSlider(end: 0 | 1, ...names: Names): Promise<void> {
    const { x, y, width, height } = await this.find(...names)
    const now = await this.evaluate<number>(`
      const { value, min, max } = furrowTest.findElement(${wordsOf(names)})
      return (value - min) / (max - min)`)
    const middle = y + height / 2
    await this.drag([
      [x + height / 2 + now * (width - height), middle],
      [x + width / 2, middle],
      [end === 0 ? x - 20 : x + width + 20, middle],
    ])
  }

  /** Resizes the window so that the page, without toolbars, has the given size. */
  async resize(width: number, height: number): Promise<void> {
    await this.browser.resize(width, height)
    const lacking = () => this.evaluate<Point>(`return [${width} - innerWidth, ${height} - innerHeight]`)
    const [across, down] = await lacking()
    if (across !== 0 || down !== 0) await this.browser.resize(width + across, height + down)
    await vi.waitFor(async () => expect(await lacking()).toEqual([0, 0]), { timeout: 5000 })
  }

  async save(name: string): Promise<void> {
    mkdirSync(OUTPUT, { recursive: true })
    writeFileSync(new URL(`${this.name}-${name}.png`, OUTPUT), await this.browser.screenshot())
  }
}

/** Messages that are ignored: performance hints of the graphics driver, and warnings of three.js about missing extensions or missing WebGPU. */
const NOT_OURS = /GL Driver Message|extension not supported|WebGPU is not available/

/** Opens a window for all tests in the current `describe`. Pages must not log warnings or errors. */
export function openWindow(kind: BrowserKind): Window {
  const window = new Window(kind.name)
  beforeAll(async () => {
    window.browser = await launch(kind)
  })
  afterAll(() => window.browser?.close())
  afterEach(async () => {
    const complaints = await window.evaluate<string[]>('return furrowTest.complaints')
    expect(complaints.filter((text) => !NOT_OURS.test(text))).toEqual([])
  })
  return window
}
