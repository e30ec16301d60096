import { readFileSync } from 'node:fs'
import * as fc from 'fast-check'
import { FurrowError } from 'furrow'
import { parseStrokes } from 'furrow/author'
import { STROKE_DEFAULTS } from 'furrow/internal'
import { describe, expect, it } from 'vitest'
import { across } from '../../strokes.ts'

const plain = {
  points: [
    [0.1, 0.2],
    [0.3, 0.4],
  ],
  width: 2,
  depth: 0.5,
}
const document = (stroke: object, more: object = {}) => ({ version: 1, strokes: [stroke], ...more })
const area = (shape: object, more: object = {}) =>
  document({ ...plain, group: 'brow' }, { areas: [{ name: 'a', shapes: [shape], ...more }] })

describe('parseStrokes', () => {
  it('fills in defaults and keeps everything else', () => {
    expect(parseStrokes(document(plain))).toEqual({
      version: 1,
      scale: 1000,
      strokes: [{ ...STROKE_DEFAULTS, ...plain }],
    })
    const full = {
      ...plain,
      group: 'brow',
      curve: 'bezier',
      points: [
        [0, 0],
        [0, 1],
        [1, 0],
        [1, 1],
      ],
      taper: [0.1, 0.2],
      shoulder: 1,
      softness: 0,
      waviness: 1,
      layer: 'up',
      depths: [0, 1, 0.5],
    }
    expect(parseStrokes(document(full, { size: 512, scale: 10 }))).toEqual({
      version: 1,
      size: 512,
      scale: 10,
      strokes: [{ ...full, shoulder: [1, 1] }],
    })
  })

  it('does not modify its input', () => {
    const json = Object.freeze(document(Object.freeze({ ...plain })))
    expect(parseStrokes(json).strokes[0]).not.toBe(plain)
  })

  it('reads the areas of a document', () => {
    const shape = { group: 'brow', radius: 3, feather: 2 }
    expect(parseStrokes(area(shape, { within: shape })).areas).toEqual([
      { name: 'a', shapes: [shape], within: shape },
    ])
  })

  it.each<[unknown, string]>([
    [
      [],
      'the document must be an object, got []; write { ... } with version, scale, size, seed, strokes, furrows, areas',
    ],
    [undefined, 'the document must be an object, got nothing'],
    [{}, 'unknown version, got nothing, allowed: 1; write "version": 1'],
    [{ ...document(plain), version: 2 }, 'unknown version, got 2, allowed: 1; write "version": 1'],
    [{ version: 1 }, 'strokes must be an array, got nothing, allowed: 1 to 10000 items; write [ ... ]'],
    [
      { version: 1, strokes: [] },
      'strokes has the wrong number of items, got 0, allowed: 1 to 10000 items; add or remove items',
    ],
    [
      document({ ...plain, widht: 3 }),
      'strokes[0] has an unknown field, got "widht", allowed: group, layer, curve, points, width, depth, depths, taper, shoulder, bank, lean, softness, waviness; did you mean "width"?',
    ],
    [
      document({ ...plain, width: '2' }),
      'strokes[0].width must be a number, got "2", allowed: 0.1..80 mm; write a plain number',
    ],
    [
      document({ ...plain, width: 0 }),
      'strokes[0].width is out of range, got 0, allowed: 0.1..80 mm; choose a value inside the range',
    ],
    [
      document({ ...plain, depth: undefined }),
      'strokes[0].depth must be a number, got nothing, allowed: -25..10 mm; write a plain number',
    ],
    [
      document({ ...plain, depth: Number.POSITIVE_INFINITY }),
      'strokes[0].depth must be a number, got Infinity, allowed: -25..10 mm; write a plain number',
    ],
    [
      document({ ...plain, taper: [0, 0, 0] }),
      'strokes[0].taper has the wrong number of items, got 3, allowed: 2 to 2 items; add or remove items',
    ],
    [
      document({ ...plain, shoulder: [0, 1.5] }),
      'strokes[0].shoulder[1] is out of range, got 1.5, allowed: 0..1; choose a value inside the range',
    ],
    [
      document({
        ...plain,
        points: [
          [0.1, 0.2],
          [0.3, -0.4],
        ],
      }),
      'strokes[0].points[1][1] is out of range, got -0.4, allowed: 0..1 of the texture; choose a value inside the range',
    ],
    [
      document({ ...plain, points: [[0.1], [0.3, 0.4]] }),
      'strokes[0].points[0] has the wrong number of items, got 1, allowed: 2 to 2 items; add or remove items',
    ],
    [
      document({ ...plain, points: [[0.1, 0.2]] }),
      'strokes[0].points has the wrong number of items, got 1, allowed: 2 to 4096 items; add or remove items',
    ],
    [
      document({
        ...plain,
        points: across(0.2, 0.1, 0.1),
      }),
      'strokes[0].points all coincide, got 2; move them apart',
    ],
    [
      document({ ...plain, curve: 'nurbs' }),
      'strokes[0].curve is unknown, got "nurbs", allowed: polyline or bezier or spline; use one of them',
    ],
    [
      document({
        ...plain,
        curve: 'bezier',
        points: [
          [0, 0],
          [0, 1],
          [1, 0],
          [1, 1],
          [0, 0],
        ],
      }),
      'strokes[0].points do not form Bezier curves, got 5, allowed: 4, 7, 10, ... points; give one end, then two handles and an end per curve',
    ],
    [
      document({ ...plain, group: '' }),
      'strokes[0].group must be text, got "", allowed: 1 to 256 characters, none of them a control character or a line break; choose another name',
    ],
    [
      document({ ...plain, depths: [1] }),
      'strokes[0].depths has the wrong number of items, got 1, allowed: 2 to 256 items; add or remove items',
    ],
    [
      document({ ...plain, depths: [1, 2] }),
      'strokes[0].depths[1] is out of range, got 2, allowed: 0..1; choose a value inside the range',
    ],
    [
      document(plain, { scale: 0 }),
      'scale is out of range, got 0, allowed: 0.000001..1000000 mm per unit; choose a value inside the range',
    ],
    [document(plain, { size: 100.5 }), 'size must be a whole number, got 100.5; round it'],
    [
      document(plain, { areas: [{ name: '../../x', shapes: [] }] }),
      'areas[0].name is not a valid file name, got "../../x", allowed: e.g. __.._x; choose another name',
    ],
    [
      area({ group: 'nose', radius: 1, feather: 1 }),
      'areas[0].shapes[0].group has no strokes, got "nose", allowed: brow; use the name of a group of strokes',
    ],
    [
      area({ group: 'brow', polygon: [], radius: 1, feather: 1 }),
      'areas[0].shapes[0] must have exactly one kind of shape, got {"group":"brow","polygon":[],"radius":1,"feather":1}, allowed: polygon or group; give one of the two',
    ],
    [
      area({ polygon: plain.points, feather: 1 }),
      'areas[0].shapes[0].polygon has the wrong number of items, got 2, allowed: 3 to 4096 items; add or remove items',
    ],
    [
      area({ group: 'brow', radius: 1, feather: 0 }),
      'areas[0].shapes[0].feather is out of range, got 0, allowed: 0.1..200 mm; choose a value inside the range',
    ],
  ])('refuses %j: %s', (json, message) => {
    const attempt = () => parseStrokes(json)
    expect(attempt).toThrow(FurrowError)
    expect(attempt).toThrow(`parseStrokes: ${message}`)
  })

  it('refuses two areas with one name', () => {
    const sketch = { name: 'a', shapes: [{ group: 'brow', radius: 1, feather: 1 }] }
    expect(() => parseStrokes(document({ ...plain, group: 'brow' }, { areas: [sketch, sketch] }))).toThrow(
      'parseStrokes: areas[1].name is already used, got "a"; give every area its own name',
    )
  })

  it('parses any JSON or throws a FurrowError', () => {
    const only = (json: unknown) => {
      try {
        parseStrokes(json)
      } catch (error) {
        expect(error).toBeInstanceOf(FurrowError)
      }
    }
    fc.assert(fc.property(fc.jsonValue(), only))
    // Makes documents that are valid except for one field, to test the reader of every field.
    const fields = [
      'group',
      'layer',
      'curve',
      'points',
      'width',
      'depth',
      'depths',
      'taper',
      'shoulder',
      'softness',
      'waviness',
    ]
    fc.assert(
      fc.property(fc.constantFrom(...fields), fc.jsonValue(), (field, value) =>
        only(document({ ...plain, [field]: value })),
      ),
    )
    fc.assert(fc.property(fc.jsonValue(), (value) => only(document(plain, { areas: value }))))
    fc.assert(fc.property(fc.jsonValue(), (value) => only(area({ polygon: value, feather: 1 }))))
  })

  it('reads the example of the documentation', () => {
    const text = readFileSync(new URL('../../../docs/strokes-format.md', import.meta.url), 'utf8')
    const example = /```json\n([\s\S]*?)```/.exec(text)?.[1]
    const { strokes, areas } = parseStrokes(JSON.parse(example!))
    expect(strokes.length).toBeGreaterThan(1)
    expect(areas!.length).toBeGreaterThan(0)
  })
})
