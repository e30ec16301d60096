/** Tests that edits of wrinkle lines redraw the onset map: on the face, and in the exported file as `furrow strokes` draws it. */

import { cpSync, readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import type { Page } from 'playwright-core'
import sharp from 'sharp'
import { beforeAll, expect, test } from 'vitest'
import { writePlain } from './avatars.ts'
import { openStudio } from './opened-studio.ts'
import { runFurrow } from './run-furrow.ts'
import {
  button,
  chooseLook,
  chooseTool,
  dropPlain,
  eventually,
  expectPicture,
  exportFile,
  meanPngDifference,
  shootAside,
  slider,
  startDrawingLines,
  undoIs,
} from './studio-page.ts'

const studio = openStudio({ width: 1200, height: 640 }, writePlain)
let page: Page
/** Picture of the onset of the automatic wrinkles. */
let automatic: Buffer

const lines = () => page.getByLabel('Line', { exact: true })
const changed = async () => {
  await eventually(async () =>
    expect(await meanPngDifference(automatic, await shootAside(page))).toBeGreaterThan(0.01),
  )
}

beforeAll(async () => {
  ;({ page } = studio)
  await dropPlain(page, studio.folder, 'foreheadInnerLeft')
  await page.getByText('Making wrinkles').waitFor({ state: 'detached' })
  await page.getByRole('slider', { name: /^Divider/ }).press('Home')
  await chooseLook(page, 'Onset')
  await page.keyboard.press('Escape')
  const forehead = await lineNamed(/forehead/)
  expect(forehead).toBeGreaterThan(0)
})

/** Shows the lines, and returns the index of the first option whose text matches. */
async function lineNamed(name: RegExp): Promise<number> {
  await startDrawingLines(page)
  await chooseTool(page, 'Bend')
  const names = await lines().locator('option').allTextContents()
  await chooseTool(page, 'Select')
  return names.findIndex((each) => name.test(each))
}

/** Runs a task with a line chosen, and hides the lines afterwards. */
async function edit(name: RegExp, task: () => Promise<void>): Promise<void> {
  const index = await lineNamed(name)
  await chooseTool(page, 'Bend')
  await lines().selectOption({ index })
  await task()
  await chooseTool(page, 'Select')
}

test('the view of the onset shows a deeper, a bent and a deleted line, and undo and redo', async () => {
  automatic = await shootAside(page)
  const undone = async () => {
    await button(page, 'Undo').click()
    await expectPicture(page, automatic)
  }
  await edit(/forehead/, async () => {
    await slider(page, 'Depth, mm').fill('3')
    await slider(page, 'Depth, mm').dispatchEvent('change')
    await undoIs(page, 'Change the depth of a line')
  })
  await changed()
  await undone()
  await button(page, 'Redo').click()
  await changed()
  await undone()
  await edit(/forehead/, async () => {
    await page.getByRole('button', { name: /^Point 2 of/ }).press('Shift+ArrowUp')
    await undoIs(page, 'Move a point')
  })
  await changed()
  await undone()
  await edit(/forehead/, () => button(page, 'Delete line').click())
  await changed()
  await undone()
})

test('the exported onset equals what furrow strokes draws from the exported lines', async () => {
  await edit(/forehead/, async () => {
    await slider(page, 'Depth, mm').fill('2')
    await slider(page, 'Depth, mm').dispatchEvent('change')
    await slider(page, 'Width, mm').fill('5')
    await slider(page, 'Width, mm').dispatchEvent('change')
    await page.getByRole('button', { name: /^Point 3 of/ }).press('Shift+ArrowDown')
    await undoIs(page, 'Move a point')
  })
  await edit(/^Crow/, () => button(page, 'Delete line').click())
  await edit(/^Chin/, () => button(page, 'Copy to the other side').click())
  const download = await exportFile(page)
  writeFileSync(join(studio.folder, 'edited.glb'), readFileSync(await download.path()))
  const run = async (...words: string[]) => {
    const { code, stderr } = await runFurrow(studio.folder, {}, ...words)
    expect({ code, stderr }).toMatchObject({ code: 0 })
  }
  await run('unpack', 'edited.glb', '-o', 'edited')
  const inFolder = (path: string) => join(studio.folder, path)
  cpSync(inFolder('edited'), inFolder('redrawn'), { recursive: true })
  await run('strokes', 'redrawn/strokes.json', '--face', 'redrawn/face.glb', '--into', 'redrawn')
  const { layers } = JSON.parse(readFileSync(inFolder('edited/wrinkles.json'), 'utf8'))
  const withOnset = layers.filter(({ onset }: { onset?: string }) => onset)
  expect(withOnset.length).toBeGreaterThan(1)
  for (const { onset } of withOnset) {
    const [own, redrawn] = await Promise.all(
      ['edited', 'redrawn'].map((folder) =>
        sharp(inFolder(`${folder}/${onset}`))
          .greyscale()
          .raw()
          .toBuffer(),
      ),
    )
    expect(own.some((byte) => byte > 0)).toBe(true)
    expect(own.equals(redrawn), onset).toBe(true)
  }
})
