// One page on the oldest and on the newest three.js, built from the packed package; `three.heavy.test.ts` has the releases between.

import type { Browser } from 'playwright-core'
import { afterAll, beforeAll, expect, it } from 'vitest'
import { NEWEST_THREE, OLDEST_THREE } from '../../packages/furrow/src/three/three-version.ts'
import { openBrowser } from '../pages/browser.ts'
import { remove, temporaryFolder } from './npm.ts'
import { type Drawn, expectSameUnlit, reportOf, UNLIT_PAGE } from './three-releases.ts'

let folder: string
let browser: Browser
beforeAll(async () => {
  folder = await temporaryFolder()
  browser = await openBrowser()
})
afterAll(async () => {
  await browser?.close()
  await remove(folder)
})

it('the oldest three.js draws the influence and the normals that the newest one draws', async () => {
  const releases = [OLDEST_THREE['furrow/three'], NEWEST_THREE]
  const [oldest, newest] = await Promise.all(
    releases.map((release) => reportOf<Drawn>(browser, folder, release, UNLIT_PAGE)),
  )
  expect([oldest!.release, newest!.release]).toEqual(releases.map(String))
  expectSameUnlit(oldest!, newest!)
})
