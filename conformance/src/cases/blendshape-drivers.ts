import type { Sample, SampleFile } from '../sample.ts'
import { AREAS, at, driven, HALF, link, morph } from './driven-square.ts'

const UP_AND_DOWN = [link('up', 0.5), link('down', 2)]

export const BLENDSHAPE_SAMPLES: readonly Sample[] = [
  {
    name: 'morph-sum',
    rule: 'By default, a driver adds its links times their weights and clamps the sum to 0..1.',
    section: 'driver of type morph',
    file: driven([
      morph('a', UP_AND_DOWN),
      morph('b', [link('up'), link('down', -1)]),
      morph('c', [link('down'), link('up', -1)]),
    ]),
    poses: [at(0, 0, 0), at(0.75, 0.25, 0, HALF), at(1, 0, 0.25, { weights: { up: 0.5, down: 0.75 } })],
  },
  {
    name: 'morph-max-min',
    rule: 'The rules max and min take the largest and the smallest link.',
    section: 'driver of type morph',
    file: driven([morph('a', UP_AND_DOWN, { rule: 'max' }), morph('b', UP_AND_DOWN, { rule: 'min' })]),
    poses: [at(0.5, 0.25, 0, HALF), at(0.5, 0, 0, { weights: { up: 1 } })],
  },
  {
    name: 'morph-product',
    rule: 'The rule product multiplies the links.',
    section: 'driver of type morph',
    file: driven([morph('a', UP_AND_DOWN, { rule: 'product' })]),
    poses: [at(0.125, 0, 0, HALF), at(0, 0, 0, { weights: { up: 1 } })],
  },
  {
    name: 'curve',
    rule: 'A curve is linear between its points and constant beyond them.',
    section: 'driver of type morph',
    file: driven([
      morph('a', [link('up')], {
        curve: [
          [0.2, 0.1],
          [0.6, 0.3],
          [0.8, 1],
        ],
      }),
    ]),
    poses: [
      at(0.1, 0, 0),
      at(0.2, 0, 0, { weights: { up: 0.4 } }),
      at(0.65, 0, 0, { weights: { up: 0.7 } }),
      at(1, 0, 0, { weights: { up: 0.9 } }),
    ],
  },
  {
    name: 'link-curve',
    rule: 'A link can have its own curve, applied before its weight.',
    section: 'link',
    file: driven([
      morph('a', [
        {
          ...link('up', 0.5),
          curve: [
            [0, 0],
            [1, 4],
          ],
        },
        link('down', -1),
      ]),
    ]),
    poses: [at(0.75, 0, 0, HALF), at(0.2, 0, 0, { weights: { up: 0.1 } })],
  },
  {
    name: 'missing-target',
    rule: 'A blendshape that the model lacks has weight 0.',
    section: 'driver',
    file: driven([morph('a', [link('up'), link('sneer')]), morph('b', [link('sneer')])]),
    poses: [at(0.5, 0, 0, HALF)],
  },
  {
    name: 'spellings',
    rule: 'Blendshapes are found by alternative spellings of their names.',
    section: 'driver of type morph',
    file: driven([morph('a', [link('browOuterUpLeft')]), morph('b', [link('jawOpen')])], {
      targets: [{ name: 'browOuterUp_L' }, { name: 'blendShape1.jawOpen' }],
    }),
    poses: [at(0.4, 0.7, 0, { weights: { browOuterUp_L: 0.4, 'blendShape1.jawOpen': 0.7 } })],
  },
  {
    name: 'split-target',
    rule: 'If the model has a blendshape as left and right halves, its weight is their mean.',
    section: 'driver of type morph',
    file: driven([morph('a', [link('browInnerUp')])], {
      targets: [{ name: 'browInnerUpLeft' }, { name: 'browInnerUpRight' }],
    }),
    poses: [at(0.5, 0, 0, { weights: { browInnerUpLeft: 0.8, browInnerUpRight: 0.2 } })],
  },
  {
    name: 'several-drivers',
    rule: 'All drivers of an area add to its resting activation, up to 1.',
    section: 'driver',
    file: driven([morph('a', [link('up')]), morph('a', [link('down')])], {
      areas: AREAS.map((area) => ({ ...area, ...(area.name === 'a' && { activation: 0.125 }) })),
    }),
    poses: [at(0.125, 0, 0), at(0.875, 0, 0, HALF), at(1, 0, 0, { weights: { up: 0.5, down: 0.75 } })],
  },
  {
    name: 'conflict',
    rule: 'If two blendshapes conflict, the smaller weight is subtracted from both.',
    section: 'driver of type conflict',
    file: driven([
      morph('a', [link('up')]),
      morph('b', [link('down')]),
      { type: 'conflict', targets: ['up', 'down'] },
    ]),
    poses: [
      at(0.25, 0, 0, HALF),
      at(0, 0.5, 0, { weights: { up: 0.25, down: 0.75 } }),
      at(1, 0, 0, { weights: { up: 1 } }),
    ],
  },
  {
    name: 'conflicts-in-order',
    rule: 'Conflicts are resolved in the order of the list.',
    section: 'driver of type conflict',
    file: driven([
      { type: 'conflict', targets: ['up', 'down'] },
      { type: 'conflict', targets: ['down', 'smile'] },
      morph('a', [link('up')]),
      morph('b', [link('down')]),
      morph('c', [link('smile')]),
    ]),
    poses: [at(0, 0, 0.25, { weights: { up: 0.25, down: 0.75, smile: 0.75 } })],
  },
  {
    name: 'shapes',
    rule: 'Corrections of recognised shapes do not change drivers, which read blendshapes by name.',
    section: 'Shapes',
    file: withShapes([
      { mesh: 'square', target: 'up', shape: 'mouthSmile' },
      { target: 'down' },
      { mesh: 'other', target: 'smile', shape: 'browInnerUp' },
    ]),
    poses: [at(0.5, 0.25, 0, HALF)],
  },
  {
    name: 'malformed-shapes',
    rule: 'Malformed corrections of shapes are ignored.',
    section: 'Shapes',
    file: withShapes([null, { target: 7 }, { target: 'up', shape: 'joy' }, {}]),
    poses: [at(0.5, 0.25, 0, HALF)],
  },
]

/** Returns a square whose file contains corrections of automatically recognised blendshapes. */
function withShapes(shapes: readonly unknown[]): SampleFile {
  return driven([morph('a', [link('up')]), morph('b', [link('down')])], {
    edit: (json) => {
      json.materials[0].extensions.FURROW_wrinkle_maps.shapes = shapes
    },
  })
}
