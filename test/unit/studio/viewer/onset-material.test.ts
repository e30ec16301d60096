import { expect, it } from 'vitest'
import { onsetColours } from '../../../../studio/src/viewer/looks/onset-material.ts'

const colourAt = (colours: Uint8Array, i: number) => [...colours.subarray(4 * i, 4 * i + 4)]

it('the mixed border of a scaled map has the colour of the line', () => {
  const line = [0, 0, 32, 96, 128, 128, 128, 128]
  const data = Uint8Array.from({ length: 64 }, (_, i) => line[i % 8])
  const colours = onsetColours({ width: 8, height: 8, data })
  for (let x = 2; x < 8; x++) expect(colourAt(colours, 24 + x), `${x}`).toEqual(colourAt(colours, 31))
  expect(colourAt(colours, 25)).not.toEqual(colourAt(colours, 31))
})

it('onset is dark where wrinkles begin at once, orange where they begin early, and blue from 0.5 on', () => {
  const colourOf = (onset: number) =>
    colourAt(onsetColours({ width: 4, height: 4, data: new Uint8Array(16).fill(onset) }), 5)
  const [atOnce, early, between, late, latest] = [0, 1, 64, 128, 255].map(colourOf)
  expect(Math.max(...atOnce.slice(0, 3))).toBeLessThan(64)
  expect(early[0] - early[2]).toBeGreaterThan(100)
  expect(late[2] - late[0]).toBeGreaterThan(100)
  expect(between[0]).toBeGreaterThan(late[0])
  expect(between[0]).toBeLessThan(early[0])
  expect(latest).toEqual(late)
  for (const [, , , alpha] of [atOnce, early, between, late]) expect(alpha).toBe(255)
})
