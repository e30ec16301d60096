import { autoWrinkles } from 'furrow/author'
import { AUTO_STEPS } from 'furrow/internal'
import { expect, test } from 'vitest'
import { sheet } from './sheet.ts'

const { positions, uvs, indices, offsets } = sheet(16, 0)
const skin = {
  positions: positions.map((millimetres) => millimetres / 1000),
  uvs,
  indices,
  targets: [{ name: 'bend', offsets: offsets.map((millimetres) => millimetres / 1000) }],
}

test('progress only grows, and reports parts of long steps', () => {
  const seen: [number, string][] = []
  autoWrinkles(skin, { size: 64 }, (done, total, step) => {
    expect(total).toBe(AUTO_STEPS.length)
    seen.push([done, step])
  })
  expect(seen.map(([done]) => done)).toEqual(seen.map(([done]) => done).sort((a, b) => a - b))
  expect(seen.filter(([, step]) => step === 'maps').length).toBeGreaterThan(3)
  expect(seen.at(-1)).toEqual([AUTO_STEPS.length, 'done'])
})

test('an error in the progress callback ends the work', () => {
  const stop = () => {
    throw new Error('cancelled')
  }
  expect(() => autoWrinkles(skin, { size: 64 }, stop)).toThrow('cancelled')
})
