import type { Page } from 'playwright-core'
import { contrast } from './pixels.ts'
import { type CanvasPixels, makeCanvasReadable, readCanvas } from './read-canvas.ts'

export const SECOND = 1000

/** Milliseconds after which the face of an example looks surprised. The surprised look lasts equally long. */
const SURPRISE_DELAY = 1.5 * SECOND

/** Opens a page whose clock is paused. Returns when the canvas exists, before anything is drawn. */
export async function openPaused(page: Page, url: string): Promise<void> {
  await makeCanvasReadable(page)
  await page.clock.install({ time: 0 })
  await page.clock.pauseAt(SECOND)
  await page.goto(url)
  // The page adds its canvas after the load event.
  await page.waitForSelector('canvas')
}

/**
 * Resizes a page and waits for the event. Otherwise, a frame at the old size could show the face large enough for relief, and the next frames
 * would keep the split triangles.
 */
export async function resize(page: Page, size: { width: number; height: number }): Promise<void> {
  await page.evaluate(() => {
    const heard = new Promise((resolve) => addEventListener('resize', resolve, { once: true }))
    // Stores a function, because `evaluate` would await a promise.
    Object.assign(window, { heard: () => heard })
  })
  await page.setViewportSize(size)
  await page.evaluate('window.heard()')
}

/** Advances a paused example until its face looks surprised. */
export async function playSurprise(page: Page): Promise<void> {
  await firstPicture(page)
  // Each step draws one frame: one at the start of the transition to the expression, one after its end.
  await page.clock.fastForward(SURPRISE_DELAY + SECOND / 10)
  await page.clock.fastForward(SECOND / 2)
}

/**
 * Advances a page until relief is ready and blood no longer changes. Blood follows the face with a delay. Imports modules with the import
 * map of the page.
 */
export async function drawSettled(page: Page): Promise<void> {
  const library = await libraryOf(page)
  if (library === 'furrow/babylon') {
    // Babylon.js has no relief, and skips meshes whose shaders are still compiled.
    const isReady = `import('@babylonjs/core/Engines/engineStore.js').then((m) => m.EngineStore.LastCreatedScene.isReady())`
    while (!(await page.evaluate(isReady))) await page.clock.runFor(SECOND / 60)
    await page.clock.fastForward(60 * SECOND)
    return page.clock.runFor(SECOND / 30)
  }
  await page.evaluate(`
    Promise.all([import('three'), import('${library}')]).then(([{ Scene }, { wrinklesOf }]) => {
      Scene.prototype.onBeforeRender = (_, scene) => {
        const all = new Set()
        scene.traverse((object) => object.isMesh && all.add(wrinklesOf(object)))
        window.reliefReady ??= Promise.all([...all].map((wrinkles) => wrinkles?.reliefReady()))
      }
    })`)
  await page.clock.runFor(SECOND / 60)
  await page.evaluate('window.reliefReady')
  await page.clock.fastForward(60 * SECOND)
  await page.clock.runFor(SECOND / 30)
}

/** Switches the wrinkles of all meshes off or on. The next frame shows the change. Imports modules with the import map of the page. */
export async function switchWrinkles(page: Page, mode: 'off' | 'default'): Promise<void> {
  const library = await libraryOf(page)
  if (library === 'furrow/babylon') {
    return page.evaluate(`
      Promise.all([import('@babylonjs/core/Engines/engineStore.js'), import('${library}')]).then(
        ([{ EngineStore }, { wrinklesOf }]) => {
          for (const wrinkles of wrinklesOf(EngineStore.LastCreatedScene)) wrinkles.mode = '${mode}'
        })`)
  }
  await page.evaluate(`
    Promise.all([import('three'), import('${library}')]).then(([{ Scene }, { wrinklesOf }]) => {
      Scene.prototype.onBeforeRender = (_, scene) =>
        scene.traverse((object) => {
          const wrinkles = object.isMesh && wrinklesOf(object)
          if (wrinkles) wrinkles.mode = '${mode}'
        })
    })`)
}

/** Returns the entry point of `furrow` that the page uses, as named in its import map. */
async function libraryOf(page: Page): Promise<string> {
  const imports = await page.locator('script[type=importmap]').textContent()
  return ['furrow/three', 'furrow/babylon'].find((name) => imports!.includes(name)) ?? 'furrow/webgpu'
}

/** Draws two frames and reads the second, which shows changes that the first one applies. */
export async function readNextFrame(page: Page): Promise<CanvasPixels> {
  await page.clock.runFor(SECOND / 30)
  return readCanvas(page)
}

/** Contrast, 0..255, above which a picture shows a face. A background alone has less. */
const FACE_CONTRAST = 50

/** Advances the page's clock until the face is drawn, so that every run draws the same picture. */
export async function firstPicture(page: Page): Promise<void> {
  for (;;) {
    await page.clock.runFor(SECOND / 60)
    if (contrast(await readCanvas(page)) > FACE_CONTRAST) return
    // The renderer starts in real time, not in the time of the page's clock.
    await page.waitForTimeout(SECOND / 4)
  }
}
