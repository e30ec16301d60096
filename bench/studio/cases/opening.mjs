import { StudioPage } from '../studio-page.mjs'

/** Drops avatars without wrinkles. Measures the time until the first frame with the face, and until the first frame with automatic wrinkles. */
export async function measureOpening(bench, add) {
  for (const [name, path] of Object.entries(bench.files.avatars)) {
    const studio = await StudioPage.open(bench)
    await studio.drop(path)
    await studio.waitForWrinkles()
    await studio.waitForIdle()
    const { drop, ready, wrinkled, frames } = await studio.page.evaluate(() => {
      const { events, ready, wrinkled, frames } = window.probe
      return { drop: events.drop, ready: ready.at(-1), wrinkled, frames }
    })
    const frameAfter = (time) => frames.find((frame) => frame > time) - drop
    add(`drop to face: ${name}`, frameAfter(ready))
    add(`drop to wrinkles: ${name}`, frameAfter(wrinkled))
    await studio.close()
  }
}
