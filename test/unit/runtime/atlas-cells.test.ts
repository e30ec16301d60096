import { describe, expect, it } from 'vitest'
import { clamp } from '../../../packages/furrow/src/math/scalar.ts'
import { AtlasCells } from '../../../packages/furrow/src/runtime/atlas-cells.ts'
import { Face } from '../../../packages/furrow/src/runtime/face.ts'

const slots = { slots: [], version: 0 } as unknown as Face['slots']
const faces = (count: number) => Array.from({ length: count }, () => new Face(slots, []))

describe('the sample position of an atlas cell', () => {
  it.each([
    [1, 1, 1],
    [1, 7, 3],
    [16, 16, 1],
    [128, 64, 5],
  ])('%i x %i texels, one of %i: at least half a texel within the cell', (width, height, count) => {
    const cells = new AtlasCells(width, height)
    cells.add(faces(count))
    const { inside, grid } = cells
    const { columns, rows } = grid
    const place = { x: 0, y: 0, z: 0, w: 0 }
    for (let index = 0; index < count; index++) {
      cells.locate(index, place)
      for (const at of [-3, 0, 0.5 / width, 0.3, 0.5, 1 - 0.5 / height, 1, 4]) {
        const u = place.x + clamp(at * inside.x + inside.z, 0, 1) * place.z
        const v = place.y + clamp(at * inside.y + inside.w, 0, 1) * place.w
        const [column, row] = [index % columns, Math.floor(index / columns)]
        expect(u).toBeCloseTo((column + clamp(at, 0.5 / width, 1 - 0.5 / width)) / columns, 12)
        expect(v).toBeCloseTo((row + clamp(at, 0.5 / height, 1 - 0.5 / height)) / rows, 12)
      }
    }
  })
})
