import { EXPRESSIONS, type WrinkleSet } from 'furrow'
import { reference } from 'furrow/internal'
import { ExpressionPlayer } from 'furrow/three'
import { type MeshStandardMaterial, NoColorSpace } from 'three'
import { beforeAll, describe, expect, it } from 'vitest'
import type { Face } from '../../stage/face.ts'
import {
  faceScene,
  HEIGHT,
  loadUndriven,
  referenceInfluence,
  renderWith,
  uvMaterial,
  WIDTH,
  wrinkledMaterial,
} from './face.ts'
import { harnessOn, RENDERERS } from './harness.ts'

/** Expression and view of the figures in the paper. */
const FIGURES = [
  { figure: '8', expression: 'surprised', view: 'front' },
  { figure: '9, left brow', expression: 'leftBrow', view: 'front' },
  { figure: '9, right brow', expression: 'rightBrow', view: 'front' },
  { figure: '10', expression: 'leftWink', view: 'three-quarter' },
] as const

describe.each(RENDERERS)('figures on %s', (name) => {
  const harness = harnessOn(name)
  let face: Face
  let set: WrinkleSet
  beforeAll(async () => {
    ;({ face, set } = await loadUndriven())
    // The paper's shader lights colours without sRGB decoding, so compare without decoding.
    const { map } = face.skin.material as MeshStandardMaterial
    map!.colorSpace = NoColorSpace
  })

  it.each(FIGURES)('equal the float64 reference, in figure $figure', async ({ expression, view }) => {
    const stage = faceScene(face, view)
    const wrinkles = new harness.Wrinkles(face.skin, set, { mode: 'paper' })
    const player = new ExpressionPlayer(face.root, wrinkles)
    player.play(expression, 0)
    const { activations } = EXPRESSIONS.find((known) => known.name === expression)!
    const uvs = await renderWith(harness, face, stage, uvMaterial(harness))
    const exact = referenceInfluence(uvs, set, activations)
    const influence = await renderWith(harness, face, stage, wrinkles.createInfluenceMaterial())
    const paper = await harness.render(stage.scene, stage.camera, WIDTH, HEIGHT)
    wrinkles.mode = 'off'
    const plain = face.skin.material as MeshStandardMaterial
    const smooth = await renderWith(harness, face, stage, plain)
    const wrinkled = await renderWith(harness, face, stage, wrinkledMaterial(plain, set))
    player.play('neutral', 0)
    wrinkles.dispose()

    let visible = 0
    let worst = 0
    let wrong = 0
    for (let i = 0; i < exact.length; i++) {
      if (Number.isNaN(exact[i])) continue
      visible++
      worst = Math.max(worst, Math.abs(influence[i * 4] - exact[i]))
      const pixel = (picture: Float32Array) => [...picture.subarray(i * 4, i * 4 + 3)]
      const expected = reference.mixColours(pixel(smooth), pixel(wrinkled), exact[i])
      if (pixel(paper).some((value, c) => Math.abs(value - expected[c]) > 2 / 255)) wrong++
    }
    expect(visible).toBeGreaterThan(0.2 * WIDTH * HEIGHT)
    expect(worst).toBeLessThanOrEqual(1 / 255)
    expect(wrong / visible).toBeLessThanOrEqual(0.001)
  })
})
