import { flat, image, type MapImage, noise, normals, SIDE, uniform } from '../map-image.ts'
import type { Sample, SampleArea, SampleLayer } from '../sample.ts'

const WEIGHTS = noise(1)
const area = (name: string, more: Partial<SampleArea> = {}): SampleArea => ({
  name,
  weights: WEIGHTS,
  ...more,
})
const skin = (more: Partial<SampleLayer> = {}): SampleLayer => ({ name: 'skin', normal: normals(2), ...more })
/** Returns a layer with a flat normal map, so that only its other maps have an effect. */
const flatLayer = (more: Partial<SampleLayer>): SampleLayer => ({
  name: 'skin',
  normal: flat(),
  kind: 'detail',
  ...more,
})
const base = normals(3)

/**
 * Weights that increase from left to right in red, and are 136 of 255 in green. Engines may combine areas by `max` per
 * texel or per sample, and both give the same result for these weights.
 */
const RAMP = image(SIDE, (column) => [17 * column, 136, 255])

/** Returns noise whose green channel is at most 100. A larger onset magnifies the rounding errors of texture filters beyond the tolerance. */
function onsetImage(seed: number): MapImage {
  const map = noise(seed)
  const data = map.data.map((value, i) => (i % 3 === 1 ? Math.round((value * 100) / 255) : value))
  return { ...map, data }
}
const SHARED = onsetImage(15)

export const LAYER_SAMPLES: readonly Sample[] = [
  {
    name: 'replace',
    rule: "Influence mixes the normals of a replace layer with the material's normals.",
    section: 'Mixing',
    file: { base, layers: [skin({ kind: 'replace' })], areas: [area('a', { activation: 0.7 })] },
    poses: [{ activations: { a: 0.7 } }],
  },
  {
    name: 'detail',
    rule: "Reoriented normal mapping adds the slopes of a detail layer to the material's normals.",
    section: 'Mixing',
    file: { base, layers: [skin({ kind: 'detail' })], areas: [area('a', { activation: 0.8 })] },
    poses: [{ activations: { a: 0.8 } }],
  },
  {
    name: 'kind-by-default',
    rule: 'The default kind of a layer is replace.',
    section: 'layer',
    file: { base, layers: [skin()], areas: [area('a', { activation: 1 })] },
    poses: [{ activations: { a: 1 } }],
  },
  {
    name: 'replace-and-detail',
    rule: 'Detail layers apply on top of the result of replace layers.',
    section: 'Mixing',
    file: {
      base,
      layers: [skin({ kind: 'detail' }), { name: 'age', kind: 'replace', normal: normals(4) }],
      areas: [area('a', { activation: 0.9 }), area('b', { layer: 1, channel: 1, activation: 0.7 })],
    },
    poses: [{ activations: { a: 0.9, b: 0.7 } }],
  },
  {
    name: 'two-details',
    rule: 'The slopes of detail layers are added.',
    section: 'Mixing',
    file: {
      base,
      layers: [skin({ kind: 'detail' }), { name: 'age', kind: 'detail', normal: normals(4) }],
      areas: [area('a', { activation: 0.6 }), area('b', { layer: 1, channel: 1, activation: 0.6 })],
    },
    poses: [{ activations: { a: 0.6, b: 0.6 } }],
  },
  {
    name: 'four-layers',
    rule: 'If the influences of replace layers sum to more than 1, they are divided by their sum.',
    section: 'Mixing',
    file: {
      base,
      layers: [5, 6, 7, 8].map((seed, i) => ({ name: `layer${i}`, kind: 'replace', normal: normals(seed) })),
      areas: [0, 1, 2, 3].map((layer) => {
        return area(`area${layer}`, { layer, channel: (layer % 3) as 0 | 1 | 2, activation: 1 })
      }),
    },
    poses: [{ activations: { area0: 1, area1: 1, area2: 1, area3: 1 } }],
  },
  {
    name: 'normal-scale',
    rule: "The scale of a layer's normal texture multiplies x and y of its normals.",
    section: 'layer',
    file: {
      base,
      layers: [skin({ kind: 'detail', normalScale: 0.4 })],
      areas: [area('a', { activation: 1 })],
    },
    poses: [{ activations: { a: 1 } }],
  },
  {
    name: 'material-normal-scale',
    rule: "The scale of the material's own normal texture multiplies x and y of the mixed normals.",
    section: 'Mixing',
    file: {
      base,
      baseScale: 0.4,
      layers: [skin(), { name: 'age', kind: 'detail', normal: normals(4), normalScale: 0.7 }],
      areas: [area('a', { activation: 0.8 }), area('b', { layer: 1, channel: 1, activation: 0.6 })],
    },
    poses: [{ activations: { a: 0.8, b: 0.6 } }],
  },
  {
    name: 'no-normal-map',
    rule: "Without a normal map, a material has the surface's normals and its layers use TEXCOORD_0.",
    section: 'Implementation notes',
    file: { layers: [skin()], areas: [area('a', { activation: 1 })] },
    poses: [{ activations: { a: 1 } }],
  },
  {
    name: 'channels',
    rule: 'An area reads the channel of its texture that `channel` names.',
    section: 'area',
    file: {
      base,
      layers: [skin()],
      areas: [
        area('r'),
        area('g', { channel: 1, activation: 0.5 }),
        area('b', { channel: 2, activation: 0.25 }),
      ],
    },
    poses: [{ activations: { r: 0, g: 0.5, b: 0.25 } }],
  },
  {
    name: 'sum',
    rule: 'Overlapping areas of a layer are added, and the sum is clamped to 1.',
    section: 'Influence',
    file: {
      base,
      layers: [skin()],
      areas: [0, 1, 2].map((channel) =>
        area(`${channel}`, { channel: channel as 0 | 1 | 2, activation: 0.9 }),
      ),
    },
    poses: [{ activations: { 0: 0.9, 1: 0.9, 2: 0.9 } }],
  },
  {
    name: 'max',
    rule: 'Areas that combine by max contribute their maximum.',
    section: 'Influence',
    file: {
      base,
      layers: [skin()],
      areas: [0, 1].map((channel) => {
        return area(`${channel}`, { weights: RAMP, channel: channel as 0 | 1, combine: 'max', activation: 1 })
      }),
    },
    poses: [{ activations: { 0: 1, 1: 1 } }],
  },
  {
    name: 'sum-and-max',
    rule: 'The influence is the larger of the sum and the maximum.',
    section: 'Influence',
    file: {
      base,
      layers: [skin()],
      areas: [
        area('a', { weights: RAMP, activation: 0.5 }),
        area('b', { weights: RAMP, activation: 0.5 }),
        area('c', { weights: RAMP, channel: 1, combine: 'max', activation: 1 }),
      ],
    },
    poses: [{ activations: { a: 0.5, b: 0.5, c: 1 } }],
  },
  {
    name: 'many-areas',
    rule: 'A material can have up to 256 areas.',
    section: 'FURROW_wrinkle_maps',
    file: {
      base,
      layers: [skin()],
      areas: Array.from({ length: 256 }, (_, i) => {
        return area(`area${i}`, { channel: (i % 3) as 0 | 1 | 2, activation: i % 64 === 7 ? 0.25 : 0 })
      }),
    },
    poses: [
      {
        activations: Object.fromEntries(
          Array.from({ length: 256 }, (_, i) => [`area${i}`, i % 64 === 7 ? 0.25 : 0]),
        ),
      },
    ],
  },
  {
    name: 'names',
    rule: 'Names can have all characters except control characters, and are case-sensitive.',
    section: 'Names',
    file: {
      base,
      layers: [skin()],
      areas: [
        area('Stirn / links', { activation: 0.5 }),
        area('stirn / links', { channel: 1 }),
        area('\u984d', { channel: 2, activation: 0.5 }),
      ],
    },
    poses: [{ activations: { 'Stirn / links': 0.5, 'stirn / links': 0, '\u984d': 0.5 } }],
  },
  {
    name: 'base-color',
    rule: "A layer's base colour is mixed with the material's in linear space.",
    section: 'Mixing',
    file: { base, layers: [flatLayer({ baseColor: noise(9) })], areas: [area('a', { activation: 1 })] },
    poses: [{ activations: { a: 1 } }],
  },
  {
    name: 'occlusion',
    rule: "A layer's occlusion is mixed with the material's, by its strength.",
    section: 'Mixing',
    file: {
      base,
      layers: [flatLayer({ occlusion: noise(10), occlusionStrength: 0.6 })],
      areas: [area('a', { activation: 1 })],
    },
    poses: [{ activations: { a: 1 } }],
  },
  {
    name: 'roughness',
    rule: "A layer's roughness is mixed with the material's.",
    section: 'Mixing',
    // The surface has no normal map, so highlights depend only on roughness.
    file: {
      layers: [flatLayer({ roughness: noise(11), normalScale: 0 })],
      areas: [area('a', { activation: 1 })],
    },
    poses: [{ activations: { a: 1 } }],
  },
  {
    name: 'blood',
    rule: 'Blood multiplies the base colour by the transmittance of haemoglobin.',
    section: 'Blood',
    file: {
      base,
      layers: [flatLayer({ blood: noise(12), bloodAmplitude: 1.2 })],
      areas: [area('a', { activation: 1 })],
    },
    poses: [{ activations: { a: 1 } }],
  },
  {
    name: 'blood-at-rest',
    rule: 'A blood value of 128 does not change the colour.',
    section: 'Blood',
    file: {
      base,
      layers: [flatLayer({ blood: uniform(0, 0, 128), bloodAmplitude: 2 })],
      areas: [area('a', { activation: 1 })],
    },
    poses: [{ activations: { a: 1 } }],
  },
  {
    name: 'onset',
    rule: 'An onset map delays the influence of its layer, for normals and all other maps.',
    section: 'Onset',
    file: {
      base,
      layers: [skin({ kind: 'detail', baseColor: noise(13), onset: onsetImage(14) })],
      areas: [area('a', { weights: uniform(255, 255, 255), activation: 0.6 })],
    },
    poses: [{ activations: { a: 0.6 } }],
  },
  {
    name: 'onset-shared',
    rule: 'Onset shares the image of occlusion and blood, has a strength, and does not change other layers.',
    section: 'Onset',
    file: {
      base,
      layers: [
        skin({ occlusion: SHARED, blood: SHARED, bloodAmplitude: 1, onset: SHARED, onsetStrength: 0.7 }),
        { name: 'age', kind: 'detail', normal: normals(4), blood: noise(12), bloodAmplitude: 1 },
      ],
      areas: [
        area('a', { weights: uniform(255, 255, 255), activation: 0.5 }),
        area('b', { layer: 1, channel: 1, activation: 0.7 }),
      ],
    },
    poses: [{ activations: { a: 0.5, b: 0.7 } }],
  },
]
