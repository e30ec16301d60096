// Runs all steps of `apps/releases/main.js`, on the first and last release of each range in docs/versions.md.

import { beforeAll, describe, expect, it } from 'vitest'
import { NEWEST_THREE, OLDEST_THREE } from '../../packages/furrow/src/three/three-version.ts'
import { useBrowser } from '../pages/browser.ts'
import { useFolder } from './pages.ts'
import { type Drawn, expectAllFeatures, expectSameUnlit, reportOf } from './three-releases.ts'

const RELEASES = [160, 161, 162, 165, 166, 169, 170, 172, 173, 182, 185, 186]
const NO_RELIEF =
  /^Wrinkles\.relief of mesh "skin": three\.js is too old for relief, got "r16[01]", allowed: r162 or later/

const folder = useFolder()
const browser = useBrowser()
let newest: Drawn
beforeAll(async () => {
  newest = await reportOf<Drawn>(browser(), folder(), NEWEST_THREE, 'index.html')
})
it('the newest three.js draws all features, including relief', () => {
  expectAllFeatures(newest, newest)
  const { relief, default: plain } = newest.light.result
  expect(relief).not.toEqual(plain)
  expect(newest.light.warnings).toEqual([])
})

it.each(RELEASES)('r%i draws the same as the newest three.js, except for light', async (release) => {
  const drawn = await reportOf<Drawn>(browser(), folder(), release, 'index.html')
  expect(drawn.release).toBe(String(release))
  expectSameUnlit(drawn, newest)
  expectAllFeatures(drawn, newest)
  const { relief, default: plain } = drawn.light.result
  if (release < 162) {
    expect(relief).toEqual(plain)
    expect(drawn.light.warnings).toEqual([expect.stringMatching(NO_RELIEF)])
  } else {
    expect(relief).not.toEqual(plain)
    expect(drawn.light.warnings).toEqual([])
  }
})

describe('an unsupported three.js', () => {
  it.each([
    ['webgl', OLDEST_THREE['furrow/three'] - 1, 'furrow/three'],
    ['webgpu', 168, 'furrow/webgpu'],
    ['webgpu', OLDEST_THREE['furrow/webgpu'] - 1, 'furrow/webgpu'],
  ] as const)(
    'keeps the face plain and names the required release, for %s on r%i',
    async (way, release, entry) => {
      // Without `--force`, npm refuses releases outside the range in `peerDependencies`.
      const options = ['--force']
      const page = `refused-${way}.html` as const
      const report = await reportOf<{ warnings: string[]; meshes: number }>(
        browser(),
        folder(),
        release,
        page,
        options,
      )
      const oldest = OLDEST_THREE[entry]
      expect(report.warnings).toEqual([
        expect.stringContaining(
          `Wrinkles of ${entry}: three.js is too old, got "r${release}", allowed: r${oldest} or later; npm install three@^0.${oldest}.0`,
        ),
      ])
      expect(report.meshes).toBeGreaterThan(0)
    },
  )
})
