import { expect, it } from 'vitest'
import { areaAt } from '../../../studio/src/document/area-at.ts'
import { depthOf, setDepth, setStrength, strengthOf } from '../../../studio/src/document/region.ts'
import { areaOf, frozen, sampleDocument, strokeOf, weightsOf } from './sample-document.ts'

const document = frozen({
  ...sampleDocument(),
  strokes: [
    strokeOf('folds', 'frown'),
    { ...strokeOf('folds', 'frown'), depth: -1 },
    strokeOf('folds', 'forehead'),
  ],
})

it('the depth of a region scales all its lines, and no others', () => {
  expect(depthOf(document, 'frown')).toBe(1)
  const changed = setDepth(document, 'frown', 2)
  expect(changed.strokes.map(({ depth }) => depth)).toEqual([1, -2, 0.5])
  expect(changed.strokes[2]).toBe(document.strokes[2])
  expect(depthOf(document, 'cheeks')).toBe(0)
  expect(setDepth(document, 'cheeks', 2)).toBe(document)
})

it('the depth of one side also scales lines that both sides share', () => {
  const shared = { ...document, strokes: [strokeOf('folds', 'brow')] }
  expect(setDepth(shared, 'browLeft', 1).strokes[0].depth).toBe(1)
})

it('all regions of the forehead set the depth of the lines that they share', () => {
  const shared = { ...document, strokes: [strokeOf('folds', 'foreheadOuter')] }
  expect(depthOf(shared, 'foreheadInnerLeft')).toBe(0.5)
  expect(setDepth(shared, 'foreheadInnerRight', 1).strokes[0].depth).toBe(1)
  expect(depthOf(shared, 'glabellaLeft')).toBe(0)
})

it('the strength of a region is the largest activation that its drivers give', () => {
  expect(strengthOf(document, 'frown')).toBe(1)
  const weak = setStrength(document, 'frown', 0.4)
  expect(strengthOf(weak, 'frown')).toBeCloseTo(0.4)
  expect(strengthOf(weak, 'forehead')).toBe(1)
  expect(strengthOf(setStrength(weak, 'frown', 0.8), 'frown')).toBeCloseTo(0.8)
  expect(strengthOf({ ...document, drivers: [] }, 'frown')).toBeUndefined()
})

it('the pointer is on the region with the greatest weight, and on blood only where nothing else is', () => {
  const areas = [
    areaOf('chin', 'folds', 90),
    areaOf('cheek', 'folds', 120),
    areaOf('flushCheek', 'folds', 250),
  ]
  expect(areaAt(areas, [0.5, 0.5])).toBe('cheek')
  expect(areaAt([areas[2]], [0.5, 0.5])).toBe('flushCheek')
  expect(areaAt([{ ...areas[0], weights: weightsOf(10) }], [0.5, 0.5])).toBeNull()
})
