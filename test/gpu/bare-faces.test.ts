import { EXPRESSIONS, findTargets, type WrinkleSet } from 'furrow'
import { heightToNormal, paintAreas, parseStrokes, skinCanvas, strokesToHeight } from 'furrow/author'
import { ExpressionPlayer } from 'furrow/three'
import { beforeAll, describe, expect, it, vi } from 'vitest'
import { type Face, loadFace } from '../../stage/face.ts'
import { BARE_FACES } from './bare-faces.ts'
import { faceScene, HEIGHT, referenceInfluence, renderWith, uvMaterial, WIDTH } from './face.ts'
import { createHarness, RENDERERS } from './harness.ts'

describe.each(BARE_FACES.map((face, i) => ({ ...face, i })))(
  '$name with its own strokes and areas',
  (bare) => {
    let face: Face
    let set: WrinkleSet
    beforeAll(async () => {
      face = await loadFace(`/packed/bare-${bare.i}.glb`, 'face')
      set = author(face, await (await fetch(`/@fs${bare.strokes}`)).json())
    })

    it.each(RENDERERS)('wrinkles on %s inside its active areas, and nowhere else', async (name) => {
      const harness = await createHarness(name)
      const stage = faceScene(face, 'front')
      const warn = vi.spyOn(console, 'warn').mockImplementation(() => {})
      const wrinkles = new harness.Wrinkles(face.skin, set)
      const player = new ExpressionPlayer(face.root, wrinkles)
      player.play('surprised', 0)
      const brow = findTargets('browInnerUp', Object.keys(face.skin.morphTargetDictionary!))
      expect(brow).toHaveLength(2)
      for (const target of brow) expect(face.skin.morphTargetInfluences![target]).toBe(1)

      const shown = await harness.render(stage.scene, stage.camera, WIDTH, HEIGHT)
      const influence = await renderWith(harness, face, stage, wrinkles.createInfluenceMaterial())
      const places = await renderWith(harness, face, stage, uvMaterial(harness))
      for (const area of wrinkles.areaNames) wrinkles.setActivation(area, 0)
      const plain = await harness.render(stage.scene, stage.camera, WIDTH, HEIGHT)
      const { activations } = EXPRESSIONS.find((expression) => expression.name === 'surprised')!
      const exact = referenceInfluence(places, set, activations)
      const counts = { worst: 0, reached: 0, changed: 0, stray: 0 }
      for (let i = 0; i < exact.length; i++) {
        if (Number.isNaN(exact[i])) continue
        counts.worst = Math.max(counts.worst, Math.abs(influence[i * 4] - exact[i]))
        const changed = [0, 1, 2].some((c) => shown[i * 4 + c] !== plain[i * 4 + c])
        if (exact[i] > 0.9) counts.reached++
        if (exact[i] > 0.9 && changed) counts.changed++
        if (influence[i * 4] === 0 && changed) counts.stray++
      }
      expect(counts.worst).toBeLessThanOrEqual(1 / 255)
      expect(counts.reached).toBeGreaterThan(500)
      expect(counts.changed / counts.reached).toBeGreaterThan(0.5)
      expect(counts.stray).toBe(0)
      wrinkles.dispose()
      harness.dispose()
      warn.mockRestore()
    })
  },
)

/** Draws strokes on a face without wrinkles, and makes all maps and areas from them. */
function author({ skin }: Face, strokes: unknown): WrinkleSet {
  const { geometry } = skin
  const document = parseStrokes(strokes)
  const mesh = {
    positions: geometry.getAttribute('position').array as Float32Array,
    uvs: geometry.getAttribute('uv').array as Float32Array,
    indices: geometry.index!.array as Uint16Array,
  }
  const canvas = skinCanvas(mesh, 512)
  const normal = heightToNormal(strokesToHeight(document.strokes, canvas), canvas.metric, 'derivative')
  const areas = paintAreas(document, skinCanvas(mesh, 128))
  return { layers: [{ name: 'expression', kind: 'replace', normal }], areas }
}
