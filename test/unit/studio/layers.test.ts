import { describe, expect, it } from 'vitest'
import {
  addLayer,
  moveLayer,
  removeLayer,
  renameLayer,
  setLayer,
  setMap,
} from '../../../studio/src/document/layers.ts'
import { addStroke, removeStroke, replaceStroke, strokesOf } from '../../../studio/src/document/strokes.ts'
import { areaOf, frozen, sampleDocument, strokeOf } from './sample-document.ts'

const document = frozen(sampleDocument())
const layerNames = ({ layers }: typeof document) => layers.map(({ name }) => name)

describe('a layer', () => {
  it('is added without maps, up to four', () => {
    const three = addLayer(document, 'left')
    expect(three.layers[2]).toEqual({
      name: 'left',
      kind: 'detail',
      maps: {},
      normalScale: 1,
      occlusionStrength: 1,
    })
    expect(three.layers[0]).toBe(document.layers[0])
    const four = addLayer(three, 'right')
    expect(() => addLayer(four, 'more')).toThrow('too many layers, got 5, allowed: 4')
    expect(() => addLayer(document, 'up')).toThrow('another layer already has this name')
  })

  it('is renamed in areas and strokes too, and other layers stay', () => {
    const after = renameLayer(document, 'up', 'raised')
    expect(layerNames(after)).toEqual(['raised', 'down'])
    expect(after.areas.map(({ layer }) => layer)).toEqual(['raised', 'down', 'down'])
    expect(after.strokes.map(({ layer }) => layer)).toEqual(['raised', 'down', 'down'])
    expect(after.areas[1]).toBe(document.areas[1])
    expect(after.strokes[1]).toBe(document.strokes[1])
    expect(after.drivers).toBe(document.drivers)
    const furrows = { size: 1, depth: 0.1, stretch: 1.2, seed: 7, layer: 'up' }
    expect(renameLayer({ ...document, furrows }, 'up', 'raised').furrows).toEqual({
      ...furrows,
      layer: 'raised',
    })
    expect(renameLayer({ ...document, furrows }, 'down', 'low').furrows).toBe(furrows)
    const bare = { ...document, areas: [areaOf('frown', 'down')], furrows }
    expect(removeLayer(bare, 'up').furrows).toBeUndefined()
    expect(renameLayer(document, 'up', 'up')).toBe(document)
  })

  it('is renamed and removed without other changes if no area or stroke uses it', () => {
    const more = addLayer(document, 'left')
    for (const after of [renameLayer(more, 'left', 'right'), removeLayer(more, 'left')]) {
      expect(after.areas).toBe(document.areas)
      expect(after.strokes).toBe(document.strokes)
    }
  })

  it('can be removed with its strokes if no area shows it', () => {
    const after = removeLayer({ ...document, areas: [areaOf('frown', 'down')] }, 'up')
    expect(layerNames(after)).toEqual(['down'])
    expect(after.strokes).toEqual(document.strokes.slice(1))
    expect(() => removeLayer(document, 'down')).toThrow('areas show the layer down, got "frown, cheeks"')
    expect(() => removeLayer({ ...after, areas: [] }, 'down')).toThrow('down is the only layer')
    expect(() => removeLayer(document, 'sideways')).toThrow('no such layer')
  })

  it('can be moved to a position', () => {
    expect(layerNames(moveLayer(document, 'up', 1))).toEqual(['down', 'up'])
    expect(layerNames(moveLayer(document, 'up', 9))).toEqual(['down', 'up'])
    expect(layerNames(moveLayer(document, 'down', 0))).toEqual(['down', 'up'])
  })

  it('can only have values that are allowed in files', () => {
    const after = setLayer(document, 'up', { kind: 'replace', normalScale: 2 })
    expect(after.layers[0]).toEqual({ ...document.layers[0], kind: 'replace', normalScale: 2 })
    expect(after.layers[0].maps).toBe(document.layers[0].maps)
    expect(() => setLayer(document, 'up', { normalScale: Number.NaN })).toThrow('normal scale of up, got NaN')
    expect(() => setLayer(document, 'up', { occlusionStrength: 1.5 })).toThrow('allowed: 0 to 1')
    expect(() => setLayer(document, 'up', { heightAmplitude: -1 })).toThrow('amplitude of the heights')
    expect(() => setLayer(document, 'up', { bloodAmplitude: 2.5 })).toThrow('allowed: 0 to 2')
    expect(() => setLayer(document, 'up', { onsetStrength: 1.1 })).toThrow('allowed: 0 to 1')
  })

  it('can get a map and lose it again', () => {
    const image = { mimeType: 'image/png', bytes: Uint8Array.of(9) }
    const after = setMap(document, 'up', 'occlusion', image)
    expect(after.layers[0].maps).toEqual({ ...document.layers[0].maps, occlusion: image })
    expect(after.layers[0].maps.normal).toBe(document.layers[0].maps.normal)
    const without = setMap(after, 'up', 'occlusion', undefined)
    expect(Object.keys(without.layers[0].maps)).toEqual(['normal'])
  })
})

describe('a stroke', () => {
  it('is added at the end of an existing layer', () => {
    const stroke = strokeOf('down', 'cheeks')
    const after = addStroke(document, stroke)
    expect(strokesOf(after, 'down')).toEqual([...document.strokes.slice(1), stroke])
    expect(after.strokes.at(-1)).toBe(stroke)
    expect(() => addStroke(document, strokeOf('sideways', 'cheeks'))).toThrow('no such layer')
  })

  it('can be replaced at its position by none, one or two strokes', () => {
    const [first, second, third] = document.strokes
    const [a, b] = [strokeOf('down', 'frown', 0.6), strokeOf('down', 'frown', 0.7)]
    expect(removeStroke(document, second).strokes).toEqual([first, third])
    expect(replaceStroke(document, second, [a, b]).strokes).toEqual([first, a, b, third])
    expect(replaceStroke(document, second, [a]).strokes[2]).toBe(third)
  })
})
