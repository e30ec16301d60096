import { autoWrinkles } from 'furrow/author'
import { expect, test } from 'vitest'
import { sheet } from './sheet.ts'

/** Returns a sheet of 4 x 4 squares, which one blendshape shortens, in units of `scale`. */
function skin(scale: number) {
  const { positions, uvs, indices, offsets } = sheet(4, 20)
  return {
    positions: positions.map((value) => scale * value),
    uvs,
    indices,
    targets: [{ name: 'press', offsets: offsets.map((value) => scale * value) }],
  }
}

test.each([10, 1e6])(
  'a sheet in units %d times as large has the lines of one in metres',
  (factor) => {
    const settings = { size: 128, frame: 'derivative' } as const
    const [metres, other] = [0.004, 0.004 * factor].map((scale) => autoWrinkles(skin(scale), settings))
    expect(other.areas.map(({ lines }) => lines)).toEqual(metres.areas.map(({ lines }) => lines))
  },
  60_000,
)
