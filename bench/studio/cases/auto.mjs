/** Measures how long `furrow/auto` takes in its worker, on a page that does nothing else. */
export async function measureAuto({ browser, origin, files, autoFaces }, add) {
  const page = await browser.newPage()
  page.setDefaultTimeout(0)
  await page.goto(`${origin}/auto/bench/studio/auto.html`)
  await page.waitForFunction(() => 'auto' in window)
  for (const [name, size] of autoFaces) {
    if (name === 'scan' && !files.avatars.scan) continue
    const run = () => page.evaluate(([path, side]) => window.auto(path, side), [`/auto/${name}.glb`, size])
    // The first run loads the worker's code.
    await run()
    add(`furrow/auto: ${name} at ${size}`, await run())
  }
  await page.close()
}
