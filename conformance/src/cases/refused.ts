import { noise, normals, SIDE } from '../map-image.ts'
import type { Sample, SampleFile } from '../sample.ts'

const file: SampleFile = {
  base: normals(3),
  layers: [{ name: 'skin', normal: normals(2) }],
  areas: ['a', 'b'].map((name) => ({ name, weights: noise(1), activation: 1 })),
}

interface WrinkleJson {
  layers: { normalTexture: Record<string, unknown>; [key: string]: unknown }[]
  areas: Record<string, unknown>[]
  [key: string]: unknown
}

/** A file whose extension breaks a rule. */
function refused(
  name: string,
  rule: string,
  section: string,
  spoil: (json: WrinkleJson) => void,
  whole: SampleFile = file,
): Sample {
  const edit: SampleFile['edit'] = (json) => spoil(json.materials[0].extensions.FURROW_wrinkle_maps)
  return { name: `refused-${name}`, rule, section, file: { ...whole, edit }, poses: [] }
}

export const REFUSED_SAMPLES: readonly Sample[] = [
  refused('no-layers', 'A material has at least one layer.', 'FURROW_wrinkle_maps', (json) => {
    json.layers = []
  }),
  refused('five-layers', 'A material has at most four layers.', 'FURROW_wrinkle_maps', (json) => {
    json.layers = ['1', '2', '3', '4', '5'].map((name) => ({ ...json.layers[0], name }))
  }),
  refused('layer-names', 'The names of layers are unique.', 'Names', (json) => {
    json.layers = [json.layers[0], json.layers[0]]
  }),
  refused('area-names', 'The names of areas are unique.', 'Names', (json) => {
    json.areas[1].name = 'a'
  }),
  refused('name', 'A name has no control characters.', 'Names', (json) => {
    json.areas[0].name = 'a\n'
  }),
  refused('layer', 'The layer of an area exists.', 'area', (json) => {
    json.areas[0].layer = 1
  }),
  refused('channel', 'A channel is 0 to 3.', 'area', (json) => {
    json.areas[0].channel = 4
  }),
  refused('combine', 'Areas combine by sum or max.', 'area', (json) => {
    json.areas[0].combine = 'product'
  }),
  refused('activation', 'A resting activation is 0 to 1.', 'area', (json) => {
    json.areas[0].activation = 1.5
  }),
  refused('kind', 'A layer replaces or is a detail.', 'layer', (json) => {
    json.layers[0].kind = 'overlay'
  }),
  refused('texture', 'The texture of a layer exists.', 'textureInfo', (json) => {
    json.layers[0].normalTexture.index = 99
  }),
  refused('sizes', 'All textures of one kind have one size.', 'layer', () => {}, {
    ...file,
    layers: [...file.layers, { name: 'age', normal: normals(4, SIDE / 2) }],
  }),
  refused('blood', "A layer's blood is in the texture of its occlusion.", 'Blood', () => {}, {
    ...file,
    layers: [{ ...file.layers[0], occlusion: noise(5), blood: noise(6), bloodAmplitude: 1 }],
  }),
]
