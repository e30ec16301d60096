import type { Sample } from '../sample.ts'
import { at, driven, HALF, link, morph } from './driven-square.ts'

/** Returns the quaternion of a rotation by 90 degrees about x, y or z. */
const turn = (axis: 0 | 1 | 2) => [0, 1, 2].map((i) => (i === axis ? Math.SQRT1_2 : 0)).concat(Math.SQRT1_2)
const JOINTS = [{ name: 'head' }, { name: 'jaw', translation: [0, 0, 0.1] }]
const QUARTER = [
  [0, 0],
  [Math.PI, 1],
]

/** Blendshape that compresses the square along x by 20%. */
const SQUEEZE = { name: 'squeeze', move: (x: number) => [-0.2 * x, 0, 0] as const }

export const OTHER_DRIVER_SAMPLES: readonly Sample[] = [
  {
    name: 'area',
    rule: 'Drivers that read areas run after all other drivers.',
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
    rule: 'If an area drives itself through other areas, its drivers of type area are ignored.',
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
    rule: 'Until the application sets the age, it is the initial age of the first age driver.',
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
    rule: 'An unset input is 0.',
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
    rule: 'Without an axis, the angle is the total rotation from rest, relative to the other joint.',
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
    rule: 'With an axis, the angle about this axis is signed.',
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
    rule: 'A distance is measured between two nodes, in metres.',
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
    rule: 'Malformed drivers are ignored, and other drivers work.',
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
    rule: 'With a direction, the stretch along this direction in UV space is measured.',
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
    rule: 'The contraction of a muscle is the weight of the blendshape with its name.',
    section: 'driver of type muscle',
    file: driven([
      { type: 'muscle', name: 'corrugator', area: 'a', origin: [0, 0, -0.2], insertion: [0, 0.5, 0] },
    ]),
    poses: [at(0, 0, 0), at(0.6, 0, 0, { weights: { corrugator: 0.6 } })],
    isMoved: true,
  },
]
