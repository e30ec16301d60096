/** Tests that no work is lost when the WebGL context is lost during a stroke, or when a web worker ends during its task. */

import type { Page } from 'playwright-core'
import { beforeAll, expect, test } from 'vitest'
import { writePlain } from './avatars.ts'
import { openStudio } from './opened-studio.ts'
import {
  areaChoice,
  areaNames,
  button,
  chooseTool,
  dismiss,
  dropPlain,
  expectPicture,
  exportFile,
  meanPngDifference,
  shootAside,
  slider,
  startDrawingLines,
  undoIs,
  waitUntilReady,
} from './studio-page.ts'

const AREA = 'foreheadInnerLeft'
/** Maximum mean difference of two pictures of the same state, 0..255. */
const SAME = 0.01
const SOON = { timeout: 60_000 }

/** Members that these tests add to the page's window. */
interface Ending {
  /** Ends all workers whose URL contains `name` and sends no event, like a browser that is out of memory. Returns the number of workers. */
  endWorker(name: string): number
  /** Ends the next worker whose URL contains `name` as soon as it starts. */
  endNextWorker(name: string): void
  lost: WEBGL_lose_context
}

declare global {
  interface Window extends Ending {}
}

const studio = openStudio({ width: 1000, height: 560 }, writePlain)
let page: Page

beforeAll(async () => {
  page = studio.page
  await page.addInitScript(() => {
    const workers = new Map<Worker, string>()
    let next: string | null = null
    const { Worker } = window
    Object.assign(window, {
      endWorker: (name: string) => {
        const ended = [...workers].filter(([, url]) => url.includes(name))
        for (const [worker] of ended) worker.terminate()
        return ended.length
      },
      endNextWorker: (name: string) => {
        next = name
      },
      Worker: class extends Worker {
        constructor(url: string | URL, options?: WorkerOptions) {
          super(url, options)
          workers.set(this, String(url))
          if (next === null || !String(url).includes(next)) return
          next = null
          // The first message shows that the worker has started.
          this.addEventListener('message', () => this.terminate(), { once: true })
        }
        override terminate() {
          workers.delete(this)
          super.terminate()
        }
      },
    })
  })
  await page.reload()
  await waitUntilReady(page)
  await dropPlain(page, studio.folder, AREA)
  await page.getByText('Making wrinkles').waitFor({ state: 'detached' })
  await page.getByRole('slider', { name: /^Divider/ }).press('Home')
})

const areas = () => areaNames(page)
const note = (text: string) => page.getByRole('status').getByText(text).waitFor()

async function loseGraphics(): Promise<void> {
  await page.evaluate(() => {
    const canvas = document.querySelector<HTMLCanvasElement>('#viewport canvas')!
    window.lost = canvas.getContext('webgl2')!.getExtension('WEBGL_lose_context')!
    window.lost.loseContext()
  })
  await note('The graphics device was lost and is being restored; your work is kept')
}

const restoreGraphics = () => page.evaluate(() => window.lost.restoreContext())

/** Drags over the forehead. Calls `inTheMiddle` halfway, with the button down. */
async function stroke(inTheMiddle: () => Promise<void> = async () => {}): Promise<void> {
  const { x, y, width, height } = (await page.locator('#viewport').boundingBox())!
  const at = (u: number) => [x + u * width, y + 0.27 * height] as const
  await page.mouse.move(...at(0.45))
  await page.mouse.down()
  await page.mouse.move(...at(0.5), { steps: 5 })
  await inTheMiddle()
  await page.mouse.move(...at(0.55), { steps: 5 })
  await page.mouse.up()
}

/** Returns a picture of the stage once it no longer changes. Lines fade when the pointer rests, and relief and blood follow with a delay. */
async function settled(): Promise<Buffer> {
  await shootAside(page)
  await page.waitForTimeout(5000)
  for (let last = await shootAside(page); ; ) {
    await page.waitForTimeout(500)
    const next = await shootAside(page)
    if ((await meanPngDifference(last, next)) <= SAME / 10) return next
    last = next
  }
}

/** Makes the same stroke with and without a lost WebGL context, and expects equal pictures. */
async function expectSameStroke(label: string): Promise<void> {
  const before = await settled()
  await stroke()
  await undoIs(page, label)
  const expected = await settled()
  expect(await meanPngDifference(before, expected)).toBeGreaterThan(5 * SAME)
  await button(page, 'Undo').click()
  await expectPicture(page, before, SAME)
  await stroke(loseGraphics)
  await undoIs(page, label)
  await restoreGraphics()
  await expectPicture(page, expected, SAME)
  await button(page, 'Undo').click()
  await expectPicture(page, before, SAME)
  await stroke()
  await undoIs(page, label)
  await expectPicture(page, expected, SAME)
  await button(page, 'Undo').click()
}

test('a brush stroke and the next one are complete if the graphics are lost during the first stroke', async () => {
  await areaChoice(page, 'chin').check()
  await chooseTool(page, 'Paint')
  await expectSameStroke('Paint Chin')
  await chooseTool(page, 'Select')
  await button(page, 'Whole face').click()
})

test('a line and the next one are complete if the graphics are lost while drawing the first line', async () => {
  const neutral = await shootAside(page)
  await button(page, 'Surprised').click()
  // Waits for a frame in which the face looks surprised.
  await expect
    .poll(async () => meanPngDifference(neutral, await shootAside(page)), SOON)
    .toBeGreaterThan(50 * SAME)
  await startDrawingLines(page)
  // A faded line of the usual depth changes the picture too little.
  await slider(page, 'Depth, mm').press('End')
  await expectSameStroke('Draw a line')
  await chooseTool(page, 'Select')
})

test('a worker that ends while making wrinkles is reported; the work stays, and the next try succeeds', async () => {
  const [names, before] = [await areas(), await shootAside(page)]
  await page.evaluate(() => window.endNextWorker('auto/worker'))
  await button(page, 'Shuffle').click()
  await dismiss(page, 'the worker ended before its work was done')
  expect(await areas()).toEqual(names)
  await expectPicture(page, before, SAME)
  await button(page, 'Shuffle').click()
  await undoIs(page, 'Make automatic wrinkles')
  await button(page, 'Undo').click()
  await expectPicture(page, before, SAME)
})

test('a worker that ends while drawing is reported and restarted', async () => {
  await button(page, 'New region').click()
  await expect.poll(areas, SOON).toContain('area')
  expect(await page.evaluate(() => window.endWorker('draw/worker'))).toBeGreaterThan(0)
  await dismiss(page, 'the worker that draws strokes has ended; it is started again')
  await button(page, 'Undo').click()
  await expect.poll(areas, SOON).not.toContain('area')
})

test('a worker that ends while packing is reported, and the next try makes the file', async () => {
  await page.evaluate(() => window.endNextWorker('export/worker'))
  await button(page, 'Export').click()
  await dismiss(page, 'the worker that packs faces has ended')
  expect(await page.getByText('Packing and checking').count()).toBe(0)
  await exportFile(page)
  expect(await areas()).toContain(AREA)
})
