import type { WrinkleSet } from 'furrow'
import { beforeAll, describe, expect, it } from 'vitest'
import type { Face } from '../../stage/face.ts'
import { largestDifference, ROUNDING } from './difference.ts'
import { faceScene, HEIGHT, loadUndriven, renderWith, uvMaterial, WIDTH } from './face.ts'
import { harnessOn, RENDERERS } from './harness.ts'

describe.each(RENDERERS)('areas of the shipped face on %s', (name) => {
  const harness = harnessOn(name)
  let face: Face
  let set: WrinkleSet
  beforeAll(async () => {
    ;({ face, set } = await loadUndriven())
  })

  it.each([
    { area: 'foreheadLeft', view: 'front' },
    { area: 'crowsFeetLeft', view: 'three-quarter' },
  ] as const)('change pixels where they have influence, and no others: $area', async ({ area, view }) => {
    const stage = faceScene(face, view)
    const picture = () => harness.render(stage.scene, stage.camera, WIDTH, HEIGHT)
    const plain = await picture()
    const wrinkles = new harness.Wrinkles(face.skin, set)
    expect(largestDifference(await picture(), plain), 'nothing active').toBeLessThanOrEqual(ROUNDING)
    wrinkles.setActivation(area, 1)
    const shown = await picture()
    const influence = await renderWith(harness, face, stage, wrinkles.createInfluenceMaterial())
    const uvs = await renderWith(harness, face, stage, uvMaterial(harness))
    wrinkles.dispose()

    const counts = {
      untouched: 0,
      untouchedChanged: 0,
      core: 0,
      coreSame: 0,
      otherSide: 0,
      otherSideChanged: 0,
    }
    for (let i = 0; i < WIDTH * HEIGHT; i++) {
      if (uvs[i * 4 + 2] !== 1) continue
      const changed = [0, 1, 2].some((c) => Math.abs(shown[i * 4 + c] - plain[i * 4 + c]) > ROUNDING)
      if (influence[i * 4] === 0) {
        counts.untouched++
        if (changed) counts.untouchedChanged++
      }
      if (influence[i * 4] > 0.9) {
        counts.core++
        if (!changed) counts.coreSame++
      }
      // u > 0.5 is the person's left. Areas of the two sides overlap within 0.05 of the middle.
      if (uvs[i * 4] < 0.45) {
        counts.otherSide++
        if (changed) counts.otherSideChanged++
      }
    }
    expect(counts.untouched).toBeGreaterThan(1000)
    expect(counts.untouchedChanged).toBe(0)
    expect(counts.core).toBeGreaterThan(area === 'foreheadLeft' ? 300 : 30)
    // Some pixels inside the area stay equal, because the skin between wrinkle lines is smooth.
    expect(counts.coreSame / counts.core).toBeLessThan(0.35)
    expect(counts.otherSide).toBeGreaterThan(1000)
    expect(counts.otherSideChanged).toBe(0)
  })
})
