import fc from 'fast-check'
import {
  combineNormals,
  heightToNormal,
  type RgbaImage,
  type SkinCanvas,
  type Stroke,
  StrokeLayer,
  skinCanvas,
  strokesToOnset,
} from 'furrow/author'
import { describe, expect, it } from 'vitest'
import { drawStrokes } from '../../../packages/furrow/src/author/strokes/height.ts'
import { layOutStroke } from '../../../packages/furrow/src/author/strokes/lay-out.ts'
import { flatCanvas } from './planes.ts'
import { cylinder, folded } from './skins.ts'

const SIZE = 96

/** Returns copies of all maps of a layer, as bytes. */
const bytesOf = ({ heights, occlusion, normal, onset }: Omit<StrokeLayer, 'draw' | 'prepare' | 'sculpt'>) =>
  [heights, occlusion, normal, onset!].map(({ data }) => Buffer.from(data.buffer.slice(0)))

function redrawn(strokes: readonly Stroke[], canvas: SkinCanvas, base?: RgbaImage): Buffer[] {
  const laid = strokes.flatMap((stroke) => layOutStroke(stroke, canvas))
  const drawn = drawStrokes(laid, canvas)
  const detail = heightToNormal(drawn.heights, canvas.metric, 'derivative')
  const normal = base ? combineNormals(base, detail) : detail
  return bytesOf({ ...drawn, normal, onset: strokesToOnset(strokes, canvas) })
}

/** Returns a normal map of noise that resembles pores. */
function pores(): RgbaImage {
  const data = new Uint8Array(4 * SIZE * SIZE)
  for (let i = 0; i < data.length; i++) data[i] = i % 4 === 3 ? 0 : i % 4 === 2 ? 250 : 120 + (i % 17)
  return { width: SIZE, height: SIZE, data }
}

const coordinate = fc.double({ min: 0, max: 1, noNaN: true })
const stroke: fc.Arbitrary<Stroke> = fc.record({
  curve: fc.constantFrom('spline' as const, 'polyline' as const),
  points: fc.array(fc.tuple(coordinate, coordinate), { minLength: 2, maxLength: 4 }),
  width: fc.double({ min: 0.5, max: 6, noNaN: true }),
  depth: fc.double({ min: -2, max: 2, noNaN: true }),
  taper: fc.constantFrom<[number, number]>([0, 0], [0.3, 0.3]),
  shoulder: fc.constantFrom<[number, number]>([0.6, 0.6], [1, 0]),
  softness: fc.constant(0.4),
  waviness: fc.constantFrom(0, 0.5),
  group: fc.constantFrom('brow', 'chin'),
})

/** Random edit of a list of strokes. `at` is its position, as a fraction of the list. `steps` steps of preparation come before it. */
const edit = fc.record({
  steps: fc.constantFrom(0, 5, 40, 200),
  kind: fc.constantFrom('add', 'remove', 'replace', 'bend', 'bend', 'move', 'repeat', 'clear'),
  at: fc.double({ min: 0, max: 0.999, noNaN: true }),
  stroke,
})

type Edit = typeof edit extends fc.Arbitrary<infer T> ? T : never

function edited(strokes: readonly Stroke[], { kind, at, stroke }: Edit): readonly Stroke[] {
  const i = Math.floor(at * strokes.length)
  if (kind === 'clear') return at > 0.7 ? [] : strokes
  if (kind === 'add' || strokes.length === 0) return strokes.toSpliced(i, 0, stroke)
  if (kind === 'replace') return strokes.with(i, { ...strokes[i], points: stroke.points })
  // Repeated bends change the same stroke, in the middle of the list.
  const middle = Math.floor(strokes.length / 2)
  if (kind === 'bend') return strokes.with(middle, { ...strokes[middle], points: stroke.points })
  if (kind === 'repeat') return [...strokes, strokes[i]]
  const without = strokes.toSpliced(i, 1)
  return kind === 'remove' ? without : [...without, strokes[i]]
}

describe.each([
  ['a cylinder with two seams', () => skinCanvas(cylinder(), SIZE), undefined],
  ['a sheet that fills its texture, with pores', () => flatCanvas(60, 60, SIZE), pores()],
  ['a sheet whose halves use the same texels', () => skinCanvas(folded(), SIZE), undefined],
] as const)('edited strokes on %s', (_, make, base) => {
  const canvas = make()

  it('give the same maps, bit for bit, as drawing everything again, and change only the reported rectangles', () => {
    const sequence = fc.array(edit, { minLength: 1, maxLength: 12 })
    const follow = (edits: readonly Edit[]) => {
      const layer = new StrokeLayer(canvas, { frame: 'derivative', onset: true, ...(base && { base }) })
      let strokes: readonly Stroke[] = []
      expect(bytesOf(layer)).toEqual(redrawn(strokes, canvas, base))
      for (const each of edits) {
        const prepared = strokes[Math.floor(each.at * strokes.length)]
        const steps = prepared && layer.prepare(prepared)
        for (let i = 0; i < each.steps; i++) steps?.next()
        strokes = edited(strokes, each)
        const before = bytesOf(layer)
        const changed = layer.draw(strokes)
        const after = bytesOf(layer)
        const expected = redrawn(strokes, canvas, base)
        expect(after.map((map, i) => map.equals(expected[i]))).toEqual([true, true, true, true])
        const reported = new Uint8Array(SIZE * SIZE)
        for (const { x0, y0, x1, y1 } of changed) {
          expect(x0 >= 0 && y0 >= 0 && x1 <= SIZE && y1 <= SIZE && x0 < x1 && y0 < y1).toBe(true)
          for (let y = y0; y < y1; y++) reported.fill(1, y * SIZE + x0, y * SIZE + x1)
        }
        for (const [i, map] of after.entries()) {
          const channels = map.length / reported.length
          expect(map.every((byte, k) => byte === before[i][k] || reported[Math.floor(k / channels)])).toBe(
            true,
          )
        }
      }
    }
    fc.assert(fc.property(sequence, follow), { seed: 16, numRuns: 12 })
  })
})
