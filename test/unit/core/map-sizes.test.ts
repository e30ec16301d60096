import type { ArraySlice, Layer } from 'furrow'
import { describe, expect, it } from 'vitest'
import { checkMapSizes } from '../../../packages/furrow/src/core/maps/map-sizes.ts'

const gray = (side: number) => ({ width: side, height: side, data: new Uint8Array(side * side) })
const rgba = (side: number) => ({ width: side, height: side, data: new Uint8Array(4 * side * side) })
const layer = (maps: Partial<Layer<ArraySlice>>): Layer<ArraySlice> => ({
  name: 'skin',
  kind: 'replace',
  normal: rgba(4),
  ...maps,
})

describe("the sizes of a set's maps", () => {
  it.each([
    ['normal', [{}, { normal: rgba(8) }]],
    ['baseColor', [{ baseColor: rgba(4) }, {}, { baseColor: rgba(8) }]],
    ['roughness', [{ roughness: gray(4) }, { roughness: gray(8) }]],
    ['occlusion', [{ occlusion: gray(4) }, { occlusion: gray(8) }]],
    ['blood', [{ blood: gray(4) }, { blood: gray(8) }]],
    ['onset', [{ onset: gray(4) }, { onset: gray(8) }]],
    ['occlusion and onset', [{ occlusion: gray(4) }, { onset: gray(8) }]],
    ['occlusion and blood', [{ occlusion: gray(4) }, { blood: gray(8) }]],
  ] satisfies [string, Partial<Layer>[]][])('must be equal for %s', (kinds, maps) => {
    expect(() => checkMapSizes(maps.map(layer))).toThrow(
      `Wrinkles ${kinds} maps of the layers: image 1 differs in size from image 0, got "8 x 8", allowed: 4 x 4; scale all images of the array to one size`,
    )
  })

  it('may differ between kinds, and for slices are those of the array', () => {
    const slice = { array: {}, slice: 0, channel: 0 }
    const other = { roughness: gray(8), occlusion: gray(2), blood: gray(2) }
    expect(() => checkMapSizes([layer(other), layer({ ...other, baseColor: slice })])).not.toThrow()
  })
})
