import { noise, normals } from '../map-image.ts'
import type { Pose, Sample, SampleFile } from '../sample.ts'

const WEIGHTS = noise(1)
const LAYERS = [{ name: 'skin', normal: normals(2) }]
const AREAS = (['a', 'b', 'c'] as const).map((name, i) => ({
  name,
  weights: WEIGHTS,
  channel: i as 0 | 1 | 2,
}))
const base = normals(3)

/** A square with blendshapes `up`, `down` and `smile` that move nothing, areas a, b and c, and drivers. */
function driven(drivers: readonly object[], more: Partial<SampleFile> = {}): SampleFile {
  const targets = ['up', 'down', 'smile'].map((name) => ({ name }))
  return { base, layers: LAYERS, areas: AREAS, targets, drivers, ...more }
}

const at = (a: number, b: number, c: number, pose: Omit<Pose, 'activations'> = {}): Pose => ({
  ...pose,
  activations: { a, b, c },
})

const link = (name: string, weight?: number) => ({ name, weight })
const morph = (area: string, targets: readonly object[], more: object = {}) => ({
  type: 'morph',
  area,
  targets,
  ...more,
})
const UP_AND_DOWN = [link('up', 0.5), link('down', 2)]
const HALF = { weights: { up: 0.5, down: 0.25 } }

/** A quarter turn about x, y or z. */
const turn = (axis: 0 | 1 | 2) => [0, 1, 2].map((i) => (i === axis ? Math.SQRT1_2 : 0)).concat(Math.SQRT1_2)
const JOINTS = [{ name: 'head' }, { name: 'jaw', translation: [0, 0, 0.1] }]
const QUARTER = [
  [0, 0],
  [Math.PI, 1],
]

/** Squeezes the square in x by a fifth. */
const SQUEEZE = { name: 'squeeze', move: (x: number) => [-0.2 * x, 0, 0] as const }

export const DRIVER_SAMPLES: readonly Sample[] = [
  {
    name: 'morph-sum',
    rule: 'Links of a driver are added by default, each times its weight, and the result is 0 to 1.',
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
    rule: 'A link may have a curve of its own, before its weight.',
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
    rule: 'A blendshape that the model does not have counts as weight 0.',
    section: 'driver',
    file: driven([morph('a', [link('up'), link('sneer')]), morph('b', [link('sneer')])]),
    poses: [at(0.5, 0, 0, HALF)],
  },
  {
    name: 'spellings',
    rule: 'A blendshape is recognised in other spellings of its name.',
    section: 'driver of type morph',
    file: driven([morph('a', [link('browOuterUpLeft')]), morph('b', [link('jawOpen')])], {
      targets: [{ name: 'browOuterUp_L' }, { name: 'blendShape1.jawOpen' }],
    }),
    poses: [at(0.4, 0.7, 0, { weights: { browOuterUp_L: 0.4, 'blendShape1.jawOpen': 0.7 } })],
  },
  {
    name: 'split-target',
    rule: 'A blendshape that the model has in two halves has the mean of their weights.',
    section: 'driver of type morph',
    file: driven([morph('a', [link('browInnerUp')])], {
      targets: [{ name: 'browInnerUpLeft' }, { name: 'browInnerUpRight' }],
    }),
    poses: [at(0.5, 0, 0, { weights: { browInnerUpLeft: 0.8, browInnerUpRight: 0.2 } })],
  },
  {
    name: 'several-drivers',
    rule: 'All drivers of an area add to its resting activation, to 1 at most.',
    section: 'driver',
    file: driven([morph('a', [link('up')]), morph('a', [link('down')])], {
      areas: AREAS.map((area) => ({ ...area, ...(area.name === 'a' && { activation: 0.125 }) })),
    }),
    poses: [at(0.125, 0, 0), at(0.875, 0, 0, HALF), at(1, 0, 0, { weights: { up: 0.5, down: 0.75 } })],
  },
  {
    name: 'conflict',
    rule: 'Of two blendshapes in conflict, the smaller weight is subtracted from both.',
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
    name: 'area',
    rule: 'Areas drive areas, after all drivers with inputs from outside.',
    section: 'driver of type area',
    file: driven([
      { type: 'area', area: 'c', areas: [link('b', 0.5)] },
      { type: 'area', area: 'b', areas: [link('a')] },
      morph('a', [link('up')]),
    ]),
    poses: [at(0.5, 0.5, 0.25, HALF)],
  },
  {
    name: 'area-in-a-circle',
    rule: 'An area that drives itself through others is not driven by areas.',
    section: 'driver of type area',
    file: driven([
      { type: 'area', area: 'a', areas: [link('b')] },
      { type: 'area', area: 'b', areas: [link('a')] },
      morph('a', [link('up')]),
    ]),
    poses: [at(0.5, 0, 0, HALF)],
  },
  {
    name: 'age',
    rule: 'Age is what the application sets, and the initial age of the first such driver until then.',
    section: 'driver of type age',
    file: driven([
      {
        type: 'age',
        area: 'a',
        curve: [
          [30, 0],
          [70, 1],
        ],
        initial: 40,
      },
      {
        type: 'age',
        area: 'b',
        curve: [
          [20, 0],
          [60, 0.5],
        ],
        initial: 60,
      },
    ]),
    poses: [
      at(0.25, 0.25, 0),
      at(0.75, 0.5, 0, { inputs: { age: 60 } }),
      at(0, 0.0625, 0, { inputs: { age: 25 } }),
    ],
  },
  {
    name: 'input',
    rule: 'An input that the application has not set is 0.',
    section: 'driver of type input',
    file: driven([
      {
        type: 'input',
        name: 'stress',
        area: 'a',
        curve: [
          [-1, 0],
          [1, 1],
        ],
      },
    ]),
    poses: [at(0.5, 0, 0), at(0.75, 0, 0, { inputs: { stress: 0.5 } })],
  },
  {
    name: 'bone-angle',
    rule: 'An angle is the whole rotation from rest, relative to the other joint.',
    section: 'driver of type bone',
    file: driven([{ type: 'bone', area: 'a', joints: ['head', 'jaw'], measure: 'angle', curve: QUARTER }], {
      nodes: JOINTS,
    }),
    poses: [
      at(0, 0, 0),
      at(0.5, 0, 0, { rotations: { jaw: turn(1) } }),
      at(0, 0, 0, { rotations: { jaw: turn(1), head: turn(1) } }),
    ],
  },
  {
    name: 'bone-axis',
    rule: 'With an axis, the angle about it is signed.',
    section: 'driver of type bone',
    file: driven(
      [
        {
          type: 'bone',
          area: 'a',
          joints: ['head', 'jaw'],
          measure: 'angle',
          axis: [0, 2, 0],
          curve: [
            [-Math.PI, 0],
            [Math.PI, 1],
          ],
        },
      ],
      { nodes: JOINTS },
    ),
    poses: [
      at(0.5, 0, 0),
      at(0.75, 0, 0, { rotations: { jaw: turn(1) } }),
      at(0.25, 0, 0, { rotations: { jaw: turn(1).map((value, i) => (i === 1 ? -value : value)) } }),
      at(0.5, 0, 0, { rotations: { jaw: turn(0) } }),
    ],
  },
  {
    name: 'bone-distance',
    rule: 'A distance is that between two nodes, in metres.',
    section: 'driver of type bone',
    file: driven(
      [
        {
          type: 'bone',
          area: 'a',
          joints: ['head', 'jaw'],
          measure: 'distance',
          curve: [
            [0.1, 0],
            [0.3, 1],
          ],
        },
      ],
      { nodes: JOINTS },
    ),
    poses: [at(0, 0, 0), at(0.5, 0, 0, { translations: { jaw: [0, 0, 0.2] } })],
  },
  {
    name: 'time',
    rule: 'With a delay, an activation covers 1 - exp(-t / attack) of the way up and 1 - exp(-t / release) of the way down.',
    section: 'driver of type time',
    file: driven([morph('a', [link('up')]), { type: 'time', area: 'a', attack: 0.5, release: 2 }]),
    poses: [
      at(0, 0, 0, { seconds: 0 }),
      at(1 - Math.exp(-0.5), 0, 0, { weights: { up: 1 }, seconds: 0.25 }),
      at((1 - Math.exp(-0.5)) * Math.exp(-0.25), 0, 0, { seconds: 0.5 }),
    ],
  },
  {
    name: 'unknown-driver',
    rule: 'A driver of an unknown type is ignored.',
    section: 'driver',
    file: driven([{ type: 'weather', area: 'a', clouds: 3 }, morph('b', [link('up')])]),
    poses: [at(0, 0.5, 0, HALF)],
  },
  {
    name: 'malformed-drivers',
    rule: 'A driver that breaks a rule is left out, and the others act.',
    section: 'Schema',
    file: driven([
      morph('d', [link('up')]),
      morph('a', [link('up')], {
        curve: [
          [0, 0],
          [0.5, 1],
          [0.5, 0],
        ],
      }),
      {
        type: 'bone',
        area: 'a',
        joints: ['head', 'jaw'],
        measure: 'angle',
        axis: [0, 0, 0],
        curve: [
          [-1, 1],
          [1, 1],
        ],
      },
      morph('b', [link('up')]),
    ]),
    poses: [at(0, 0.5, 0, HALF)],
  },
  {
    name: 'expression-driver',
    rule: 'A preset expression has no effect by itself.',
    section: 'driver of type expression',
    file: driven([
      {
        type: 'expression',
        name: 'surprised',
        targets: [link('up')],
        activations: [{ area: 'a', activation: 1 }],
      },
    ]),
    poses: [at(0, 0, 0, HALF)],
  },
  {
    name: 'tension',
    rule: 'Compression is the mean of 1 - s over the area, where s is the smaller principal stretch.',
    section: 'driver of type tension',
    file: driven(
      [
        {
          type: 'tension',
          area: 'a',
          curve: [
            [0, 0],
            [0.4, 1],
          ],
        },
        {
          type: 'tension',
          area: 'b',
          measure: 'stretch',
          curve: [
            [-0.4, 0],
            [0.4, 1],
          ],
        },
      ],
      { targets: [SQUEEZE] },
    ),
    poses: [at(0, 0.5, 0), at(0.5, 0.5, 0, { weights: { squeeze: 1 } })],
    isMoved: true,
  },
  {
    name: 'tension-direction',
    rule: 'With a direction, the stretch along it in the texture counts.',
    section: 'driver of type tension',
    file: driven(
      [
        {
          type: 'tension',
          area: 'a',
          direction: [3, 0],
          curve: [
            [0, 0],
            [0.4, 1],
          ],
        },
        {
          type: 'tension',
          area: 'b',
          direction: [0, 1],
          curve: [
            [0, 0],
            [0.4, 1],
          ],
        },
      ],
      { targets: [SQUEEZE] },
    ),
    poses: [at(0, 0, 0), at(0.5, 0, 0, { weights: { squeeze: 1 } })],
    isMoved: true,
  },
  {
    name: 'muscle',
    rule: 'The contraction of a muscle is the weight of the blendshape that has its name.',
    section: 'driver of type muscle',
    file: driven([
      { type: 'muscle', name: 'corrugator', area: 'a', origin: [0, 0, -0.2], insertion: [0, 0.5, 0] },
    ]),
    poses: [at(0, 0, 0), at(0.6, 0, 0, { weights: { corrugator: 0.6 } })],
    isMoved: true,
  },
]
