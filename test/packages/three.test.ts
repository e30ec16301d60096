// Compares pictures on the oldest and the newest supported three.js. `three.heavy.test.ts` tests the releases between.

import { expect, it } from 'vitest'
import { NEWEST_THREE, OLDEST_THREE } from '../../packages/furrow/src/three/three-version.ts'
import { useBrowser } from '../pages/browser.ts'
import { useFolder } from './pages.ts'
import { type Drawn, expectSameUnlit, reportOf, UNLIT_PAGE } from './three-releases.ts'

const folder = useFolder()
const browser = useBrowser()
it('the oldest three.js draws the same influence and normals as the newest', async () => {
  const releases = [OLDEST_THREE['furrow/three'], NEWEST_THREE]
  const [oldest, newest] = await Promise.all(
    releases.map((release) => reportOf<Drawn>(browser(), folder(), release, UNLIT_PAGE)),
  )
  expect([oldest!.release, newest!.release]).toEqual(releases.map(String))
  expectSameUnlit(oldest!, newest!)
})
