import { cp, mkdir } from 'node:fs/promises'
import { join } from 'node:path'
import type { Browser } from 'playwright-core'
import { build } from 'vite'
import { expect, inject } from 'vitest'
import { openPage } from '../pages/browser.ts'
import { startStaticServer } from '../pages/static-server.ts'
import { createApp, ROOT } from './npm.ts'

/** Result of one step of the page, and the warnings during the step. */
interface Step<T> {
  result: T
  warnings: string[]
}

/** RGB pictures without light, before and after the image of an area or a layer is replaced. */
interface Unlit {
  drawn: number[]
  painted: number[]
}

/** Steps of `apps/releases/main.js` that draw without light, so that all releases of three.js must agree. */
const UNLIT = ['influence', 'normals'] as const

/** Report of `apps/releases/main.js`. */
export interface Drawn extends Record<(typeof UNLIT)[number], Step<Unlit>> {
  release: string
  /** Normals of two instances of a `BatchedMesh`, side by side, RGB. */
  batch: Step<number[]>
  light: Step<Record<'off' | 'paper' | 'composed' | 'default' | 'relief', number[]>>
}

/** File name of a page of `apps/releases`, with its query. */
type Page = `${'index' | 'refused-webgl' | 'refused-webgpu'}.html${string}`

/** Page that runs only the steps without light. */
export const UNLIT_PAGE: Page = 'index.html?step=influence&step=normals'

/**
 * Installs the packed `furrow` with a release of three.js, builds a page and opens it. `FURROW_PICTURES` names a folder for screenshots.
 *
 * @param folder folder for the application.
 * @param options options of `npm install`.
 * @returns `window.report` of the page.
 */
export async function reportOf<T>(
  browser: Browser,
  folder: string,
  release: number,
  page: Page,
  options: string[] = [],
): Promise<T> {
  const [name] = page.split('.')
  const three = `three@0.${release}`
  const packages = [inject('tarballs').furrow, three, ...options]
  const app = await createApp(join(folder, `${name}-${release}`), packages)
  await cp(join(ROOT, 'test/packages/apps/releases'), app, { recursive: true })
  await mkdir(join(app, 'public'))
  await cp(join(ROOT, 'faces/human.glb'), join(app, 'public/wrinkled.glb'))
  await build({
    root: app,
    configFile: false,
    logLevel: 'error',
    build: { target: 'es2022', rolldownOptions: { input: join(app, `${name}.html`) } },
  })
  const server = await startStaticServer(join(app, 'dist'))
  const { page: opened, complaints } = await openPage(browser)
  try {
    await opened.goto(`${server.origin}/${page}`)
    await opened.waitForFunction(() => document.title === 'done', undefined, { timeout: 0 })
    const pictures = process.env.FURROW_PICTURES
    if (pictures) await opened.screenshot({ path: join(pictures, `${name}-${release}.png`) })
    expect(complaints).toEqual([])
    return await opened.evaluate(() => (window as unknown as { report: T }).report)
  } finally {
    await opened.close()
    server.close()
  }
}

/** Checks that two releases draw the same influence and normals. */
export function expectSameUnlit(drawn: Drawn, other: Drawn): void {
  for (const step of UNLIT) {
    const [own, expected] = [drawn[step].result, other[step].result]
    for (const what of ['drawn', 'painted'] as const) {
      const difference = largestDifference(own[what], expected[what])
      expect(difference, `${step} ${what} on r${drawn.release}`).toBeLessThanOrEqual(2)
    }
    expect(largestDifference(own.drawn, own.painted), `${step} repainted`).toBeGreaterThan(30)
    expect(drawn[step].warnings).toEqual([])
  }
}

/**
 * Checks the batch and the lit pictures. Compares the lit pictures with wrinkles with the one without wrinkles of the same release, because
 * light varies by release.
 */
export function expectAllFeatures(drawn: Drawn, other: Drawn): void {
  const { result: batch, warnings } = drawn.batch
  expect(largestDifference(batch, other.batch.result), 'batch').toBeLessThanOrEqual(2)
  const sides = (['left', 'right'] as const).map((side) => halfOf(batch, side))
  expect(largestDifference(sides[0]!, sides[1]!), 'difference of the instances').toBeGreaterThan(30)
  expect(warnings).toEqual([])
  const { off, ...modes } = drawn.light.result
  for (const [mode, picture] of Object.entries(modes))
    expect(largestDifference(picture, off), mode).toBeGreaterThan(30)
}

/** Returns the largest difference of two pictures in any channel. */
function largestDifference(a: readonly number[], b: readonly number[]): number {
  expect(a.length).toBe(b.length)
  return a.reduce((largest, value, i) => Math.max(largest, Math.abs(value - b[i]!)), 0)
}

/** Returns the bytes of one half of a square RGB picture. */
function halfOf(picture: readonly number[], side: 'left' | 'right'): number[] {
  const row = 3 * Math.sqrt(picture.length / 3)
  return picture.filter((_, i) => i % row < row / 2 === (side === 'left'))
}
