import type { WrinkleDriver } from 'furrow'
import { describe, expect, it } from 'vitest'
import {
  addArea,
  addEmptyArea,
  duplicateArea,
  paintArea,
  removeArea,
  renameArea,
  setArea,
} from '../../../studio/src/document/areas.ts'
import { remake } from '../../../studio/src/document/automatic.ts'
import type { StudioDocument } from '../../../studio/src/document/document.ts'
import { areaOf, frozen, sampleDocument, weightsOf } from './sample-document.ts'

const document = frozen(sampleDocument())

/** Returns the names of the document's fields that an operation replaced. */
const changedParts = (after: StudioDocument) =>
  (Object.keys(after) as (keyof StudioDocument)[]).filter((key) => after[key] !== document[key])

const areaNames = ({ areas }: StudioDocument) => areas.map(({ name }) => name)

describe('an area', () => {
  it('is added at the end of the areas, and changes nothing else', () => {
    const area = areaOf('nose', 'up')
    const after = addArea(document, area)
    expect(after.areas.at(-1)).toBe(area)
    expect(after.areas.slice(0, 3).every((each, i) => each === document.areas[i])).toBe(true)
    expect(changedParts(after)).toEqual(['areas'])
  })

  it('can be added without weights, on the first layer', () => {
    const after = addEmptyArea(document, 'nose')
    expect(after.areas.at(-1)).toMatchObject({ layer: 'up', activation: 0, weights: { width: 4, height: 4 } })
    expect(after.areas.at(-1)!.weights.data).toEqual(new Uint8Array(16))
  })

  it.each([
    ['a taken name', () => addArea(document, areaOf('frown', 'up')), 'another area already has this name'],
    ['a name of two lines', () => addEmptyArea(document, 'a\nb'), 'the area has no usable name'],
    [
      'an unknown layer',
      () => addArea(document, areaOf('nose', 'sideways')),
      'no such layer, got "sideways"',
    ],
    [
      'another size',
      () =>
        addArea(document, {
          ...areaOf('nose', 'up'),
          weights: { width: 2, height: 4, data: new Uint8Array(8) },
        }),
      'got "2 x 4", allowed: 4 x 4 texels',
    ],
  ])('with %s is refused', (_, add, message) => {
    expect(add).toThrow(message)
  })

  it('is refused if there are 256 areas already', () => {
    const areas = Array.from({ length: 256 }, (_, i) => areaOf(`area ${i}`, 'up'))
    expect(() => addEmptyArea({ ...document, areas }, 'one more')).toThrow('too many areas, got 257')
  })

  it('can be painted without changing other areas', () => {
    const weights = weightsOf(7)
    const after = paintArea(document, 'frown', weights)
    expect(after.areas[1].weights).toBe(weights)
    expect(after.areas[0]).toBe(document.areas[0])
    expect(changedParts(after)).toEqual(['areas'])
    expect(() => paintArea(document, 'nose', weights)).toThrow('no such area')
    expect(() => paintArea(document, 'frown', { ...weights, width: 3 })).toThrow('another size')
  })

  it('has settings that must be in their ranges, and a layer that must exist', () => {
    const after = setArea(document, 'frown', { combine: 'max', activation: 0.5, layer: 'up' })
    expect(after.areas[1]).toEqual({ ...document.areas[1], combine: 'max', activation: 0.5, layer: 'up' })
    for (const activation of [-0.1, 1.1, Number.NaN]) {
      expect(() => setArea(document, 'frown', { activation })).toThrow('allowed: 0 to 1')
    }
    expect(() => setArea(document, 'frown', { layer: 'sideways' })).toThrow('no such layer')
    expect(() => setArea(document, 'nose', {})).toThrow('no such area')
  })
})

describe('renaming an area', () => {
  const after = renameArea(document, 'frown', 'glare')

  it('renames it in expressions, and in drivers that activate it or read it', () => {
    const old = JSON.stringify(document.drivers)
    expect(JSON.stringify(after.drivers)).toBe(old.replaceAll('"frown"', '"glare"'))
  })

  it('renames it in strokes and their shapes', () => {
    expect(after.strokes.map(({ group }) => group)).toEqual(['forehead', 'glare', 'glare'])
    expect(after.strokeAreas![1]).toEqual({
      name: 'glare',
      shapes: [{ group: 'glare', radius: 4, feather: 4 }],
      within: { group: 'forehead', radius: 9, feather: 4 },
    })
  })

  it('keeps the same object for each item that does not name it', () => {
    expect(after.areas[0]).toBe(document.areas[0])
    expect(after.areas[1].weights).toBe(document.areas[1].weights)
    expect(after.drivers[0]).toBe(document.drivers[0])
    expect(after.drivers[5]).toBe(document.drivers[5])
    expect(after.strokes[0]).toBe(document.strokes[0])
    expect(after.strokeAreas![0]).toBe(document.strokeAreas![0])
    expect(after.layers).toBe(document.layers)
  })

  it('keeps the same array for each list that does not name it', () => {
    const bare = addEmptyArea(document, 'nose')
    const renamed = renameArea(bare, 'nose', 'snout')
    expect(renamed.strokes).toBe(document.strokes)
    expect(renamed.drivers).toBe(document.drivers)
    expect(renamed.strokeAreas).toBe(document.strokeAreas)
  })

  it('does nothing if the name is the same, and throws if it is taken or invalid', () => {
    expect(renameArea(document, 'frown', 'frown')).toBe(document)
    expect(() => renameArea(document, 'frown', 'cheeks')).toThrow('another area already has this name')
    expect(() => renameArea(document, 'frown', '')).toThrow('no usable name')
    expect(() => renameArea(document, 'nose', 'snout')).toThrow('no such area, got "nose"')
  })
})

describe('removing an area', () => {
  const after = removeArea(document, 'frown')

  it('removes drivers that activate it, and drivers that read only this area', () => {
    expect(areaNames(after)).toEqual(['forehead', 'cheeks'])
    const types = after.drivers.map(({ type }) => type)
    expect(types).toEqual(['morph', 'area', 'muscle', 'conflict', 'expression'])
    expect(JSON.stringify(after.drivers)).not.toContain('frown')
    expect(after.drivers[1]).toMatchObject({ areas: [{ name: 'forehead', weight: 1 }] })
  })

  it('keeps its muscle drivers, because they also move the skin', () => {
    const { area, ...muscle } = document.drivers[4] as WrinkleDriver & { area: string }
    expect(after.drivers[2]).toEqual(muscle)
  })

  it('removes its stroke shapes and keeps its strokes', () => {
    expect(after.strokes).toBe(document.strokes)
    expect(after.strokeAreas).toEqual([document.strokeAreas![0]])
  })

  it('keeps drivers that do not name it', () => {
    const without = removeArea(addEmptyArea(document, 'nose'), 'nose')
    expect(without.drivers).toBe(document.drivers)
    expect(without.strokeAreas).toBe(document.strokeAreas)
  })

  it('throws if the area is unknown', () => {
    expect(() => removeArea(document, 'nose')).toThrow('no such area')
  })
})

describe('duplicating an area', () => {
  it('copies the drivers that activate it, and shares its weights', () => {
    const after = duplicateArea(document, 'cheeks')
    expect(areaNames(after)).toEqual(['forehead', 'frown', 'cheeks', 'cheeks 2'])
    expect(after.areas[3].weights).toBe(document.areas[2].weights)
    expect(after.drivers.slice(0, 7).every((driver, i) => driver === document.drivers[i])).toBe(true)
    expect(after.drivers.slice(7)).toEqual([
      { ...document.drivers[2], area: 'cheeks 2' },
      { ...document.drivers[3], area: 'cheeks 2' },
    ])
  })

  it('reads the muscle of the original, because a second muscle would move the skin twice', () => {
    const added = duplicateArea(document, 'frown').drivers.slice(7)
    expect(added.map(({ type }) => type)).toEqual(['morph', 'morph'])
    expect(added[1]).toMatchObject({ area: 'frown 2', targets: [{ name: 'corrugator', weight: 1 }] })
  })

  it('numbers a copy of a copy with the next number', () => {
    const twice = duplicateArea(duplicateArea(document, 'cheeks'), 'cheeks 2')
    expect(areaNames(twice).slice(3)).toEqual(['cheeks 2', 'cheeks 3'])
  })

  it('shortens a name of maximum length', () => {
    const name = '皺'.repeat(256)
    const after = duplicateArea(addEmptyArea(document, name), name)
    expect(after.areas.at(-1)!.name).toBe(`${'皺'.repeat(254)} 2`)
  })
})

it('making automatic wrinkles again keeps the stroke shapes of areas that remain', () => {
  const areas = document.areas.map((area) => ({ ...area, isAutomatic: area.name === 'frown' }))
  const strokes = document.strokes.map((stroke) => ({ ...stroke, isAutomatic: true }))
  const { strokeAreas: _, ...made } = document
  expect(remake({ ...document, areas, strokes }, made).strokeAreas).toEqual([document.strokeAreas![0]])
})
