import { StudioPage } from '../studio-page.mjs'

const MOVES = 6
/** Radius to watch for changes of an area or layer, CSS pixels. */
const WIDE_RADIUS = 60

/** Times moving the end of a line across the forehead, and undo and redo of the line and of a layer's field. */
export async function measureLines(bench, add) {
  for (const count of bench.counts) {
    const studio = await StudioPage.open(bench)
    const { page } = studio
    await studio.openProject(await bench.files.project(count))
    await studio.linesTo('Draw')
    const [from, to] = [await studio.pointAt(0.4, 0.23), await studio.pointAt(0.6, 0.22)]
    await studio.drag(from, to)
    await studio.waitForIdle()
    await studio.linesTo('Edit')
    await page.mouse.move(to.x, to.y)
    await page.mouse.down()
    await studio.waitForIdle()
    for (let i = 1; i <= MOVES; i++) {
      const point = { x: to.x, y: to.y + 4 * i }
      const time = await studio.timeToPixel('pointermove', point, () => page.mouse.move(point.x, point.y))
      add(`${i === 1 ? 'first ' : ''}stroke to heights: ${count} lines`, time)
    }
    await page.mouse.up()
    const end = { x: to.x, y: to.y + 4 * MOVES }
    await measureUndo(studio, end, `a line: ${count} lines`, add)
    if (count === bench.counts[0]) await measureScale(studio, end, add)
    await studio.close()
  }
}

/** Times changes of a layer's scale. */
async function measureScale(studio, point, add) {
  const { page } = studio
  await studio.linesTo('Off')
  await page.getByRole('heading', { name: 'Layers' }).click()
  await page.locator('details.layer summary').click()
  await page.locator('details.layer').getByLabel('Scale').focus()
  const press = () => page.keyboard.press('ArrowLeft')
  for (let i = 0; i < MOVES; i++) {
    await studio.waitForIdle()
    add('scale of a layer', await studio.timeToPixel('input', point, press, WIDE_RADIUS))
  }
  await measureUndo(studio, point, 'a field', add)
}

async function measureUndo(studio, point, edit, add) {
  for (const [figure, keys] of [
    ['undo', 'Control+z'],
    ['redo', 'Control+Shift+z'],
  ]) {
    await studio.waitForIdle()
    const press = () => studio.page.keyboard.press(keys)
    add(`${figure} ${edit}`, await studio.timeToPixel('keydown', point, press, WIDE_RADIUS))
  }
}
