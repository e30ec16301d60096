import { paintAreas, parseStrokes, skinCanvas, strokesToHeight } from 'furrow/author'
import { expect, test } from 'vitest'
import { layOutStrokes } from '../../../packages/furrow/src/author/strokes/lay-out.ts'
import { across } from '../../strokes.ts'
import { sheet } from './auto/sheet.ts'

test('strokes that are too long in total are refused when drawing maps or areas', () => {
  const { positions, uvs, indices } = sheet(8, 0)
  const canvas = skinCanvas({ positions, uvs, indices }, 16, 16, 1)
  const stroke = {
    group: 'a',
    points: across(0.5),
    width: 1,
    depth: 0.1,
  }
  const document = (metres: number) =>
    parseStrokes({
      version: 1,
      scale: 1,
      strokes: Array.from({ length: Math.floor(metres / (0.8 * 0.08)) }, () => stroke),
    })
  expect(layOutStrokes(document(90).strokes, canvas)).toHaveLength(1406)
  for (const draw of [
    () => paintAreas(document(110), canvas),
    () => strokesToHeight(document(110).strokes, canvas),
  ])
    expect(draw).toThrow(/strokes too long in total, got "1718 strokes", allowed: 100 m;/)
})
