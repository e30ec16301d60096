import { StudioPage } from '../studio-page.mjs'

/** Measures the longest task of the main thread while the studio makes automatic wrinkles, draws a line, paints, and opens a large mesh. */
export async function measureTasks(bench, add) {
  const studio = await StudioPage.open(bench)
  const longest = async (action) => Math.max(0, ...(await studio.longTasks(action)))
  const { human } = bench.files.avatars
  await studio.drop(human)
  add('longest task: automatic wrinkles', await longest(() => studio.waitForWrinkles()))
  await studio.chooseTool('Draw a wrinkle')
  const [from, to] = [await studio.pointAt(0.4, 0.23), await studio.pointAt(0.6, 0.22)]
  add('longest task: drawing a line', await longest(() => studio.drag(from, to)))
  await studio.chooseTool('Select')
  await studio.page
    .getByRole('radio', { name: /^Select / })
    .first()
    .check()
  const paint = async () => {
    await studio.chooseTool('Paint')
    await studio.drag(await studio.pointAt(0.56, 0.5), await studio.pointAt(0.66, 0.5))
  }
  add('longest task: painting', await longest(paint))
  if (bench.files.sheet) {
    add('longest task: opening 2,000,000 triangles', await longest(() => studio.drop(bench.files.sheet)))
  }
  await studio.close()
}
