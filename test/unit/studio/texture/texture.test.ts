import type { GrayImage } from 'furrow'
import { parseStrokes, type Stroke } from 'furrow/author'
import { positionAt } from 'furrow/internal'
import { Ray, Vector3 } from 'three'
import { expect, it } from 'vitest'
import type { LayerStroke } from '../../../../studio/src/document/document.ts'
import { BRUSH_DEFAULTS } from '../../../../studio/src/paint/brush.ts'
import { brushOutline } from '../../../../studio/src/texture/brush-outline.ts'
import { TextureLines } from '../../../../studio/src/texture/texture-lines.ts'
import { type PaintTarget, PaintTool } from '../../../../studio/src/tools/paint-tool.ts'
import { TexturePicker } from '../../../../studio/src/tools/texture-picker.ts'
import { cutSheet, empty, pickerOf, placesOf, pointerAt } from '../paint/skins.ts'

const SIZE = 64

function cutSkin() {
  const { skin, picker } = pickerOf(cutSheet())
  return { skin, picker, texture: new TexturePicker(skin, picker, SIZE) }
}

/** Ray of the camera that looks down on the texture. */
const rayAt = ([u, v]: readonly [number, number]) => new Ray(new Vector3(u, -v, 1), new Vector3(0, 0, -1))

it.each([
  [0.012, 0.031],
  [-0.04, -0.03],
])('a point of the texture is the same place as on the face: %f, %f', (x, y) => {
  const { picker, texture } = cutSkin()
  const onFace = picker.pick(new Ray(new Vector3(x, y, 5), new Vector3(0, 0, -1)))!
  const hit = texture.pick(rayAt(onFace.uv))!
  for (let k = 0; k < 3; k++) expect(hit.position[k]).toBeCloseTo(onFace.position[k], 3)
  expect(hit.point.distanceTo(onFace.point)).toBeLessThan(1e-5)
  expect(hit.normal.distanceTo(onFace.normal)).toBeLessThan(1e-5)
})

it('a point between islands is not on the skin', () => {
  expect(cutSkin().texture.pick(rayAt([0.52, 0.5]))).toBeUndefined()
})

it.each([
  [0.2, 0.8],
  [0.75, 0.5],
])(
  'the outline of the brush is at its radius on the skin, however the texture is stretched: %f, %f',
  (u, v) => {
    const { skin, texture } = cutSkin()
    const hit = texture.pick(rayAt([u, v]))!
    const { locator } = skin.mapOf(SIZE)
    const [weights, position] = [new Float64Array(3), new Float64Array(3)]
    for (const [x, y] of brushOutline(skin, hit.triangle, hit.uv, 4)) {
      positionAt(position, skin.surface, locator.find(x, y, weights), weights)
      expect(Math.hypot(...position.map((value, k) => value - hit.position[k]))).toBeCloseTo(4, 3)
    }
  },
)

it('a quick stroke from one island to another is straight in the texture, and does not paint the skin between its ends', () => {
  const { skin, texture } = cutSkin()
  let painted: GrayImage | undefined
  const tool = new PaintTool<PaintTarget>({
    target: () => ({
      name: 'a',
      image: empty(SIZE),
      brush: { ...BRUSH_DEFAULTS, radius: 3 },
      skin,
      picker: texture,
    }),
    preparation: () => null,
    onPaint: () => {},
    show: () => {},
    keep: (_, weights) => {
      painted = weights
    },
    discard: () => {},
    onHit: () => {},
  })
  const at = (u: number, v: number) => pointerAt(0, 0, { ray: rayAt([u, v]) })
  tool.begin(at(0.1, 0.8))
  tool.move([at(0.9, 0.7)])
  tool.end()
  const places = [...placesOf(skin.mapOf(SIZE), painted!)].filter(({ weight }) => weight > 0)
  const uv = places.map(({ texel }) => [(texel % SIZE) / SIZE, Math.floor(texel / SIZE) / SIZE])
  expect(uv.some(([u]) => u > 0.85)).toBe(true)
  // No painted texel is farther from the line than the radius of the brush.
  expect(uv.filter(([u, v]) => Math.abs(v - (0.8 - (u - 0.1) / 8)) > 0.04)).toEqual([])
})

it('a line across a seam is shown as two pieces, each in its island', () => {
  const { skin } = cutSkin()
  // The line goes from below the seam to above it, in the middle of the sheet.
  const points = [
    [0.245, 0.8],
    [0.9, 0.47],
  ]
  const stroke = { points, curve: 'spline', width: 2, depth: 0.5 }
  const [line] = parseStrokes({ version: 1, strokes: [stroke] }).strokes as Stroke[]
  const pieces = new TextureLines(skin, SIZE).lineOf({ ...line, layer: 'up' } as LayerStroke)
  expect(pieces.length).toBe(2)
  expect(pieces[0].every(([u]) => u < 0.48)).toBe(true)
  expect(pieces[1].every(([u]) => u > 0.57)).toBe(true)
})
