import {
  type AutoWrinkles,
  autoWrinkles,
  parseStrokes,
  type Skin,
  skinCanvas,
  strokesToHeight,
} from 'furrow/author'
import { strokesOf } from 'furrow/internal'
import { describe, expect, test } from 'vitest'
import { skinAt } from '../../../skin-at.ts'
import { decimatedSkin } from './decimated.ts'
import { FACES } from './faces.ts'

const [, HUMAN] = FACES[0]
const SIZE = 512

const human = () => skinAt(HUMAN)

/** Returns the shipped skin in centimetres, lying on its back. */
async function lying(): Promise<Skin> {
  const turned = (vectors: ArrayLike<number>) =>
    Float32Array.from(vectors, (_, i) => 100 * [vectors[i], -vectors[i + 1], vectors[i - 1]][i % 3])
  const skin = await human()
  return {
    ...skin,
    positions: turned(skin.positions),
    targets: skin.targets.map(({ name, offsets }) => ({ name, offsets: turned(offsets) })),
  }
}

/** Returns the shipped skin with both halves using the texels of the left half. */
async function folded(): Promise<Skin> {
  const skin = await human()
  return {
    ...skin,
    uvs: Float32Array.from(skin.uvs, (value, i) => (i % 2 === 0 ? 0.5 + Math.abs(value - 0.5) : value)),
  }
}

describe.each([
  ['the face that ships', human, 0],
  ['a face of 1,500 vertices', () => decimatedSkin(HUMAN, 1500), 0],
  ['a face in centimetres on its back', lying, 0],
  // Points at the middle may differ: `autoWrinkles` finds the left half in the frame of the face, `skinCanvas` in the frame of the mesh.
  ['a face whose halves use the same texels', folded, 0.08],
] as const)('%s', (_, make, exempt) => {
  test('has strokes that draw the same heights again', async () => {
    const skin = await make()
    const wrinkles: AutoWrinkles = autoWrinkles(skin, { size: SIZE })
    const document = parseStrokes(JSON.parse(JSON.stringify(strokesOf(wrinkles))))
    expect(document.size).toBe(SIZE)
    const canvas = skinCanvas(skin, SIZE, SIZE, document.scale)
    for (const { name, heights } of wrinkles.layers) {
      const strokes = document.strokes.filter(({ layer }) => layer === name)
      expect(strokes.length).toBeGreaterThan(0)
      const { data } = strokesToHeight(strokes, canvas)
      let [off, drawn, deepest] = [0, 0, 0]
      for (let i = 0; i < data.length; i++) {
        if (data[i] !== 0 || heights.data[i] !== 0) drawn++
        if (Math.abs(data[i] - heights.data[i]) > 0.005) off++
        deepest = Math.min(deepest, data[i])
      }
      // A layer may contain only the fine lines of a lip.
      expect(deepest, name).toBeLessThan(-0.05)
      expect(off / drawn, name).toBeLessThanOrEqual(exempt)
    }
    const areas = new Set(wrinkles.areas.map((area) => area.name.replace(/(Left|Right)$/, '')))
    for (const { group = '' } of document.strokes) expect(areas).toContain(group.replace(/(Left|Right)$/, ''))
  })
})

test('strokes have few points, so that artists can edit them', async () => {
  const { strokes } = strokesOf(autoWrinkles(await human(), { size: SIZE }))
  const points = strokes.reduce((sum, stroke) => sum + stroke.points.length, 0)
  expect(strokes.length).toBeGreaterThan(60)
  expect(points / strokes.length).toBeLessThan(8)
  expect(JSON.stringify(strokes).length).toBeLessThan(40_000)
})
