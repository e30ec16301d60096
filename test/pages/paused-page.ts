import type { Page } from 'playwright-core'
import { contrast } from './pixels.ts'
import { type CanvasPixels, makeCanvasReadable, readCanvas } from './read-canvas.ts'

export const SECOND = 1000

/** Milliseconds until each example's face looks surprised, and for which it stays surprised. */
const SURPRISE_DELAY = 1.5 * SECOND

/** Opens a page with its time paused. The canvas exists, and nothing is drawn yet. */
export async function openPaused(page: Page, url: string): Promise<void> {
  await makeCanvasReadable(page)
  await page.clock.install({ time: 0 })
  await page.clock.pauseAt(SECOND)
  await page.goto(url)
  // The page adds its canvas after loading.
  await page.waitForSelector('canvas')
}

/** Resizes a page and waits for its resize event. A frame of another size could split meshes for relief, which stay split for a while. */
export async function resize(page: Page, size: { width: number; height: number }): Promise<void> {
  await page.evaluate(() => {
    const heard = new Promise((resolve) => addEventListener('resize', resolve, { once: true }))
    // Awaited later.
    Object.assign(window, { heard: () => heard })
  })
  await page.setViewportSize(size)
  await page.evaluate('window.heard()')
}

/** Advances a paused example to the moment of surprise. */
export async function playSurprise(page: Page): Promise<void> {
  await firstPicture(page)
  // Two steps with one frame each: start and end of the transition.
  await page.clock.fastForward(SURPRISE_DELAY + SECOND / 10)
  await page.clock.fastForward(SECOND / 2)
}

/**
 * Draws a page in its final state: with relief, after meshes were split, and with delayed blood. Modules come from the page's import map.
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

/** Switches the wrinkles of all meshes off or on from the next frame on. Modules come from the page's import map. */
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

/** Finds the entry point for the page's renderer in its import map. */
async function libraryOf(page: Page): Promise<string> {
  const imports = await page.locator('script[type=importmap]').textContent()
  return ['furrow/three', 'furrow/babylon'].find((name) => imports!.includes(name)) ?? 'furrow/webgpu'
}

/** Reads the frame after next, which shows changes made before the next one. */
export async function readNextFrame(page: Page): Promise<CanvasPixels> {
  await page.clock.runFor(SECOND / 30)
  return readCanvas(page)
}

/** Contrast above which a picture shows a face: a plain background has less. */
const FACE_CONTRAST = 50

/** Advances the page's paused time until the face is drawn, so that every run draws the same picture. */
export async function firstPicture(page: Page): Promise<void> {
  for (;;) {
    await page.clock.runFor(SECOND / 60)
    if (contrast(await readCanvas(page)) > FACE_CONTRAST) return
    // Waits in real time while the renderer starts.
    await page.waitForTimeout(SECOND / 4)
  }
}
