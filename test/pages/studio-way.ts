/** Tests the studio by mouse, in an artist's order: open an avatar, make every kind of change, reload the page, and export. */

import { readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import type { Locator, Page } from 'playwright-core'
import sharp from 'sharp'
import { beforeAll, describe, expect, test, vi } from 'vitest'
import { writeNone } from './avatars.ts'
import { openStudio } from './opened-studio.ts'
import { runFurrow } from './run-furrow.ts'
import {
  areaChoice,
  button,
  chooseTool,
  DRAWING,
  dropPaths,
  expectPicture,
  expectValue,
  exportFile,
  GUIDE_SIZES,
  meanPngDifference,
  openRecent,
  prefer,
  savePictures,
  shootAside,
  showSliders,
  showTab,
  slider,
  undoIs,
  undoLabel,
  waitUntilReady,
} from './studio-page.ts'

/** Size of the window: small, because drawing takes most of the time. */
const WINDOW = { width: 1120, height: 700 }

const studio = openStudio(WINDOW, writeNone)
let page: Page

const area = (name: string) => slider(page, name)

/** Vertical positions of the forehead's wrinkle lines and of the chin, as fractions of the viewport's height from the top. */
export interface Heights {
  forehead: number
  chin: number
}

/** Positions on the shipped face. */
export const HUMAN_HEIGHTS: Heights = { forehead: 0.23, chin: 0.67 }

/** Maximum mean difference of two pictures of the same state, 0..255. */
const SAME = 0.01

beforeAll(() => {
  ;({ page } = studio)
})

/** Avatar whose UV layout has a seam along the middle of the face. `make` returns null if the avatar is not available. */
export interface Avatar {
  kind: string
  file: string
  heights: Heights
  make: () => Promise<Uint8Array | null>
}

/** Adds the tests for one avatar. The studio is open for all tests of the file. */
export function describeWay({ kind, file, heights, make }: Avatar): void {
  describe(kind, () => walk(file, heights, make))
}

function walk(file: string, heights: Heights, make: Avatar['make']) {
  const forehead: Box = [0.4, heights.forehead - 0.045, 0.6, heights.forehead + 0.045]
  const chin: Box = [0.45, heights.chin - 0.04, 0.55, heights.chin + 0.04]
  let bytes: Uint8Array | null
  const name = file.replace(/\..*/, '')
  /** Undo labels of the changes so far. */
  const steps: string[] = []
  let made: Buffer
  let changed: Buffer
  const step = (title: string, body: () => Promise<void>) =>
    test(title, async ({ skip }) => {
      if (!bytes) return skip('../shared/real-face is missing')
      await body()
    })

  beforeAll(async () => {
    bytes = await make()
    if (bytes) writeFileSync(join(studio.folder, file), bytes)
  })

  step('the dropped avatar gets wrinkles, and raised brows crease its forehead', async () => {
    await dropPaths(page, [join(studio.folder, file)], title(name))
    await areaChoice(page, 'foreheadInnerLeft').waitFor()
    await vi.waitFor(async () => expect(await page.getByText('Making wrinkles').count()).toBe(0), DRAWING)
    await picture('open')
    await dragSlider(page.getByRole('slider', { name: /^Divider/ }), 0)
    for (const { input } of await blendshapes(/^brow.*Up/)) await dragSlider(input, 1)
    await vi.waitFor(
      async () => expect(Number(await area('foreheadInnerLeft').inputValue())).toBeGreaterThan(0.8),
      DRAWING,
    )
    made = await shootAside(page)
    await picture('wrinkles')
    await prefer(page, 'Shading of wrinkles', 'Off')
    const plainFace = await shootAside(page)
    await prefer(page, 'Shading of wrinkles', 'Default')
    // Wrinkles change the forehead, and not the chin.
    expect(await differenceIn(made, plainFace, forehead)).toBeGreaterThan(0.5)
    expect(await differenceIn(made, plainFace, chin)).toBeLessThan(0.1)
    await expectPicture(page, made, SAME)
  })

  step('a line can be bent', async () => {
    await chooseTool(page, 'Bend')
    const line = await lineIn(forehead)
    await page.mouse.click(line.x, line.y)
    const knot = await knotIn(forehead)
    await page.mouse.move(knot.x, knot.y)
    await page.mouse.down()
    await page.mouse.move(knot.x + 3, knot.y + 12, { steps: 5 })
    await page.mouse.up()
    await undoIs(page, 'Move a point')
    await picture('line')
    await chooseTool(page, 'Select')
    await expectChange(made, forehead, 0.02)
    steps.push('Move a point')
  })

  step('an area can be painted', async () => {
    await areaChoice(page, 'chin').check()
    await chooseTool(page, 'Paint')
    const { x, y } = await placeOf([0.5, heights.chin])
    // Drags from the chin to the cheek.
    await page.mouse.move(x, y)
    await page.mouse.down()
    await page.mouse.move(x + 90, y - 40, { steps: 8 })
    await page.mouse.up()
    await undoIs(page, 'Paint Chin')
    await picture('paint')
    await chooseTool(page, 'Select')
    steps.push('Paint Chin')
  })

  step("a line can be drawn across the texture's seam", async () => {
    // With the sliders open, the stage is so low that the forehead is under the buttons of the camera.
    await button(page, 'Sliders').click()
    const before = await shootAside(page)
    await chooseTool(page, 'Draw a wrinkle')
    // Draws across the middle of the forehead, where the seam is.
    const { x, y } = await placeOf([0.5, heights.forehead])
    await page.mouse.move(x - 45, y - 12)
    await page.mouse.down()
    await page.mouse.move(x + 45, y + 10, { steps: 12 })
    await page.mouse.up()
    await undoIs(page, 'Draw a line')
    await picture('draw')
    await chooseTool(page, 'Select')
    await expectChange(before, forehead, 0.02)
    const drawn = await shootAside(page)
    // Checks the picture on both sides of the seam.
    for (const side of [-1, 1]) {
      const near = boxAround(0.5 + side * 0.018, heights.forehead)
      expect(await differenceIn(before, drawn, near), `side ${side}`).toBeGreaterThan(0.3)
    }
    steps.push('Draw a line')
  })

  step('a recorded pose drives an area', async () => {
    await button(page, 'Neutral').click()
    await puff(1)
    await areaChoice(page, 'chin').check()
    await showTab(page, 'When')
    await button(page, 'Show it in this pose').click()
    await picture('driver')
    await showTab(page, 'Look')
    await expectValue(area('chin'), 1)
    await puff(0)
    await expectValue(area('chin'), 0)
    await puff(1)
    await expectValue(area('chin'), 1)
    steps.push((await undoLabel(page))!)
    changed = await shootAside(page)
  })

  step('everything can be undone and redone', async () => {
    for (const label of steps.toReversed()) {
      await undoIs(page, label)
      await button(page, 'Undo').click()
    }
    expect(await button(page, 'Undo').isDisabled()).toBe(true)
    await expectValue(area('chin'), 0)
    for (const _label of steps) await button(page, 'Redo').click()
    expect(await button(page, 'Redo').isDisabled()).toBe(true)
    await expectPicture(page, changed, SAME)
  })

  step('the work is unchanged after the tab was closed and the studio opened again', async () => {
    await page.getByText('Kept in this browser').waitFor()
    const context = page.context()
    const address = page.url()
    await page.close()
    page = await context.newPage()
    studio.page = page
    await page.goto(address)
    await waitUntilReady(page)
    await openRecent(page, new RegExp(`^${name}`))
    await areaChoice(page, 'chin').waitFor()
    await dragSlider(page.getByRole('slider', { name: /^Divider/ }), 0)
    await puff(1)
    await expectValue(area('chin'), 1)
    await areaChoice(page, 'chin').check()
    await expectPicture(page, changed, SAME)
  })

  step('furrow validate accepts the exported file, and furrow render draws the same picture', async () => {
    const download = await exportFile(page)
    await button(page, 'Exported file').click()
    await picture('export')
    await page.keyboard.press('Escape')
    const exported = download.suggestedFilename()
    writeFileSync(join(studio.folder, exported), readFileSync(await download.path()))
    const { code, stdout } = await runFurrow(studio.folder, {}, 'validate', exported)
    expect({ code, stdout }).toEqual({ code: 0, stdout: expect.stringContaining(': 0 errors') })
    const withWrinkles = await rendered(exported, 'default')
    const without = await rendered(exported, 'off')
    // Allows for edges of the face, which the page and `furrow render` antialias differently.
    expect(await meanPngDifference(changed, withWrinkles)).toBeLessThan(0.25)
    const apart = await differenceIn(changed, withWrinkles, chin)
    expect(await differenceIn(changed, without, chin)).toBeGreaterThan(2 * apart)
  })
}

/** Renders an exported face with puffed cheeks by `furrow render`, with the size of the stage. */
async function rendered(face: string, mode: string): Promise<Buffer> {
  const { width, height } = (await page.locator('#viewport').boundingBox())!
  const puffed = (await blendshapes(PUFF)).map(({ name }) => `${name}=1`)
  const words = ['--set', ...puffed, '--size', `${Math.round(width)}x${Math.round(height)}`, '--mode', mode]
  const { stderr } = await runFurrow(studio.folder, {}, 'render', face, '-o', `${mode}.png`, ...words)
  expect(stderr).toBe('')
  return sharp(join(studio.folder, `${mode}.png`))
    .png()
    .toBuffer()
}

/** Region in fractions of the viewport's width and height: left, top, right, bottom. */
type Box = [number, number, number, number]

function boxAround(x: number, y: number): Box {
  return [x - 0.015, y - 0.03, x + 0.015, y + 0.03]
}

/** Converts a file name to its label in the list of faces. */
function title(name: string): string {
  return name[0]!.toUpperCase() + name.slice(1)
}

async function placeOf([x, y]: readonly [number, number]): Promise<{ x: number; y: number }> {
  const box = (await page.locator('#viewport').boundingBox())!
  return { x: box.x + x * box.width, y: box.y + y * box.height }
}

/** Drags the handle of a slider to a value from 0 to 1. The divider is a slider too. */
async function dragSlider(input: Locator, value: number): Promise<void> {
  await input.scrollIntoViewIfNeeded()
  if ((await input.getAttribute('aria-orientation')) === 'horizontal') {
    const [from, to] = [(await input.boundingBox())!, await placeOf([value, 0.5])]
    await page.mouse.move(from.x + from.width / 2, from.y + from.height / 2)
    await page.mouse.down()
    await page.mouse.move(to.x, to.y, { steps: 4 })
    await page.mouse.up()
    return
  }
  const { x, y, width, height } = (await input.boundingBox())!
  const now = Number(await input.inputValue())
  // The handle is as wide as the track is high, and stays inside the track.
  const at = (fraction: number) => x + height / 2 + fraction * (width - height)
  await page.mouse.move(at(now), y + height / 2)
  await page.mouse.down()
  await page.mouse.move(value === 1 ? x + width + 20 : value === 0 ? x - 20 : at(value), y + height / 2, {
    steps: 4,
  })
  await page.mouse.up()
}

/** Finds the sliders of blendshapes by a pattern, because an avatar has one slider for both sides or one per side. */
async function blendshapes(names: RegExp): Promise<{ name: string; input: Locator }[]> {
  await showSliders(page)
  await page.getByLabel('Filter blendshapes').fill(names.source.match(/[a-z]+/)![0])
  const rows = await page.locator('#targets .row:visible').all()
  const all = await Promise.all(
    rows.map(async (row) => ({
      name: (await row.locator('label').getAttribute('title'))!,
      input: row.getByRole('slider'),
    })),
  )
  return all.filter(({ name }) => names.test(name))
}

const PUFF = /^cheekPuff/

async function puff(value: number): Promise<void> {
  for (const { input } of await blendshapes(PUFF)) await dragSlider(input, value)
}

/** Finds the pixel of one colour that is nearest to the middle of a box, on the canvas that shows wrinkle lines. */
async function overlayPixel(
  box: Box,
  colour: readonly [number, number, number],
): Promise<{ x: number; y: number }> {
  await page.mouse.move(WINDOW.width - 10, 5)
  let found: { x: number; y: number } | null = null
  await vi.waitFor(async () => {
    found = await page.locator('canvas.lines').evaluate(
      (canvas, [[left, top, right, bottom], rgb]) => {
        const { width, height } = canvas as HTMLCanvasElement
        const { data } = (canvas as HTMLCanvasElement).getContext('2d')!.getImageData(0, 0, width, height)
        const middle = [((left + right) / 2) * width, ((top + bottom) / 2) * height] as const
        let best: { x: number; y: number; distance: number } | null = null
        for (let y = Math.ceil(top * height); y < bottom * height; y++) {
          for (let x = Math.ceil(left * width); x < right * width; x++) {
            const i = 4 * (y * width + x)
            if (data[i + 3]! < 200 || rgb.some((value, k) => Math.abs(data[i + k]! - value) > 12)) continue
            const distance = Math.hypot(x - middle[0], y - middle[1])
            if (!best || distance < best.distance) best = { x, y, distance }
          }
        }
        const ratio = width / canvas.clientWidth
        return best && { x: best.x / ratio, y: best.y / ratio }
      },
      [box, colour] as const,
    )
    expect(found).not.toBeNull()
  }, DRAWING)
  const { x, y } = found!
  const origin = (await page.locator('#viewport').boundingBox())!
  return { x: origin.x + x, y: origin.y + y }
}

/** Finds a pixel on a line, by the colour of unselected lines. */
const lineIn = (box: Box) => overlayPixel(box, [255, 207, 155])
/** Finds a pixel on a control point of the selected line, by the colour of points. */
const knotIn = (box: Box) => overlayPixel(box, [255, 255, 255])

/** Saves pictures for `docs/studio.md`. @param shown element to scroll the panel to. */
async function picture(name: string, shown?: Locator): Promise<void> {
  await savePictures(page, name, GUIDE_SIZES, shown)
  await page.setViewportSize(WINDOW)
}

async function expectChange(before: Buffer, box: Box, least: number): Promise<void> {
  const check = async () =>
    expect(await differenceIn(before, await shootAside(page), box)).toBeGreaterThan(least)
  await vi.waitFor(check, DRAWING)
}

/** Returns the mean difference of two pictures of the stage within a box of the viewport, 0..255. */
async function differenceIn(a: Buffer, b: Buffer, [left, top, right, bottom]: Box): Promise<number> {
  const { width, height } = (await page.locator('#viewport').boundingBox())!
  const region = {
    left: Math.round(left * width),
    top: Math.round(top * height),
    width: Math.round((right - left) * width),
    height: Math.round((bottom - top) * height),
  }
  const [one, other] = await Promise.all([a, b].map((png) => sharp(png).extract(region).png().toBuffer()))
  return meanPngDifference(one!, other!)
}
