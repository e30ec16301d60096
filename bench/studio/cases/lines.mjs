import { StudioPage } from '../studio-page.mjs'

const MOVES = 6
/** Half the side of the square that is watched for changes after an undo or a change of a layer, CSS pixels. */
const WIDE_RADIUS = 60

/**
 * Measures response times while the end of a wrinkle line on the forehead moves. Then changes the scale of a layer, and undoes and redoes both edits.
 */
export async function measureLines(bench, add) {
  for (const count of bench.counts) {
    const studio = await StudioPage.open(bench)
    const { page } = studio
    await studio.openProject(await bench.files.project(count))
    await studio.chooseTool('Draw a wrinkle')
    const [from, to] = [await studio.pointAt(0.4, 0.23), await studio.pointAt(0.6, 0.22)]
    await studio.drag(from, to)
    await studio.waitForIdle()
    await studio.chooseTool('Bend')
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

async function measureScale(studio, point, add) {
  const { page } = studio
  await studio.chooseTool('Select')
  await page.getByRole('tab', { name: 'Maps' }).click()
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
