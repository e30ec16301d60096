import { StudioPage } from '../studio-page.mjs'

const MOVES = 10

/** Measures response times of a brush stroke over the cheek, and of its undo and redo. */
export async function measurePainting(bench, add) {
  const studio = await StudioPage.open(bench)
  const { page } = studio
  await studio.openProject(await bench.files.project(10))
  await studio.button('New region').click()
  await studio.chooseTool('Paint')
  await studio.waitForIdle()
  const at = (i) => studio.pointAt(0.56 + 0.012 * i, 0.5)
  const start = await at(0)
  await page.mouse.move(start.x, start.y)
  add('first dab, at once', await studio.timeToPixel('pointerdown', start, () => page.mouse.down()))
  for (let i = 1; i <= MOVES; i++) {
    const point = await at(i)
    add('dab', await studio.timeToPixel('pointermove', point, () => page.mouse.move(point.x, point.y)))
  }
  await page.mouse.up()
  const middle = await at(MOVES / 2)
  for (const [figure, keys] of [
    ['undo a brush stroke', 'Control+z'],
    ['redo a brush stroke', 'Control+Shift+z'],
  ]) {
    await studio.waitForIdle()
    add(figure, await studio.timeToPixel('keydown', middle, () => page.keyboard.press(keys)))
  }
  await studio.waitForIdle()
  await page.mouse.move(start.x, start.y)
  add('first dab of the next stroke', await studio.timeToPixel('pointerdown', start, () => page.mouse.down()))
  await page.mouse.up()
  await studio.close()
}
