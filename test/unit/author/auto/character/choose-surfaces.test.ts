import type { Skin } from 'furrow/author'
import { chooseSurfaces, clothNote, emptyAside, kindNote, surfaceOptions } from 'furrow/internal'
import { describe, expect, it } from 'vitest'

/** Makes a triangle of a size. With `moves`, a blendshape moves it by a distance. */
function triangle(size: number, moves?: number): Skin {
  const offsets = new Float32Array(9).fill(moves ?? 0)
  return {
    positions: [0, 0, 0, size, 0, 0, 0, size, 0],
    uvs: [0, 0, 1, 0, 0, 1],
    indices: [0, 1, 2],
    targets: moves === undefined ? [] : [{ name: 'jawOpen', offsets }],
    skeleton: { joints: [], influences: 4, indices: [], weights: [] },
  }
}

function candidate(meshName: string, materialName: string, limbs: string[], skin = triangle(1)) {
  return { meshName, materialName, limbs, skin, materialJson: undefined, isLit: true }
}

const chosen = (...args: Parameters<typeof chooseSurfaces>) =>
  chooseSurfaces(...args).surfaces.map(({ candidate, skin, tubes, cloth }) => [
    candidate.meshName,
    skin.skeleton !== undefined,
    tubes,
    cloth,
  ])

describe('the surfaces of a character that get wrinkles', () => {
  it('are the face, then skin and cloth that joints fold, largest first', () => {
    const candidates = [
      candidate('Hands', 'skin', ['left hand'], triangle(1)),
      candidate('Trousers', 'denim', ['left knee'], triangle(2)),
      candidate('Head', 'face', ['neck'], triangle(0.5, 0.1)),
      candidate('Shirt', 'top', ['waist'], triangle(3)),
      candidate('Hair', 'hair', ['neck'], triangle(9)),
    ]
    expect(chosen(candidates, {})).toEqual([
      ['Head', true, false, undefined],
      ['Shirt', true, false, 'shirt'],
      ['Trousers', true, false, 'denim'],
      ['Hands', true, false, undefined],
    ])
    const silk = chosen(candidates, { cloth: 'silk' })
    expect(silk.map(([, , , cloth]) => cloth)).toEqual([undefined, 'silk', 'silk', undefined])
  })

  it('include a face that joints do not fold, without its skeleton', () => {
    expect(chosen([candidate('Helmet', 'metal', ['neck'], triangle(1, 0.1))], {})).toEqual([
      ['Helmet', false, false, undefined],
    ])
  })

  it('include surfaces whose kind the user stated, and their chains of joints', () => {
    const candidates = [candidate('Thing', 'grey', ['chain']), candidate('Other', 'Blue', ['left elbow'])]
    expect(chosen(candidates, {})).toEqual([])
    const kinds = new Map([
      ['Thing', 'skin'],
      ['Blue', 'hard'],
    ] as const)
    expect(chosen(candidates, { kinds })).toEqual([['Thing', true, true, undefined]])
  })

  it('leave out surfaces of unknown kind and cloth that does not fold, with notes', () => {
    const found = chooseSurfaces(
      [
        candidate('Thing', 'grey', ['left elbow', 'neck']),
        candidate('Glove', '', ['left hand']),
        candidate('Rock', '', []),
      ],
      {},
    )
    expect(found.surfaces).toEqual([])
    expect(found.unknown.map((each) => kindNote(each, 'tell it'))).toEqual([
      'mesh "Thing", material "grey" (left elbow, neck) may be skin, cloth or hard, and gets no wrinkles: tell it',
    ])
    expect(clothNote(found.unfolded)).toMatch(/so it gets no folds: "Glove"$/)
    expect(emptyAside(found)).toBe(' (mesh "Thing" may be skin, cloth or hard)')
    expect(emptyAside({ unknown: [], unfolded: found.unfolded })).toMatch(/^ \(cloth folds .* "Glove"\)$/)
  })
})

it('only the first surface gets fine furrows, and only cloth the option cloth', () => {
  const options = { age: 60, furrows: true, cloth: 'silk' } as const
  expect(surfaceOptions({}, options, true)).toEqual({ age: 60, furrows: true, tubes: false })
  expect(surfaceOptions({ tubes: true }, options, false)).toEqual({ age: 60, furrows: false, tubes: true })
  expect(surfaceOptions({ cloth: 'denim' }, options, true)).toEqual({
    age: 60,
    furrows: false,
    tubes: false,
    cloth: 'denim',
  })
})
