import { noise, normals, SIDE } from '../map-image.ts'
import type { Sample, SampleFile } from '../sample.ts'

const file: SampleFile = {
  base: normals(3),
  layers: [{ name: 'skin', normal: normals(2) }],
  areas: ['a', 'b'].map((name) => ({ name, weights: noise(1), activation: 1 })),
}

const ROUGH = noise(7)

interface WrinkleJson {
  layers: { normalTexture: Record<string, unknown>; [key: string]: unknown }[]
  areas: Record<string, unknown>[]
  [key: string]: unknown
}

/** Returns a sample that breaks one rule of the extension. Engines must reject it. */
function refused(
  name: string,
  rule: string,
  section: string,
  breakRule: (json: WrinkleJson) => void,
  base: SampleFile = file,
): Sample {
  const edit: SampleFile['edit'] = (json) => breakRule(json.materials[0].extensions.FURROW_wrinkle_maps)
  return { name: `refused-${name}`, rule, section, file: { ...base, edit }, poses: [] }
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
  refused('channel', 'The channel of an area is 0 to 3.', 'area', (json) => {
    json.areas[0].channel = 4
  }),
  refused('combine', 'Areas combine by sum or max.', 'area', (json) => {
    json.areas[0].combine = 'product'
  }),
  refused('activation', 'A resting activation is 0 to 1.', 'area', (json) => {
    json.areas[0].activation = 1.5
  }),
  refused('kind', 'The kind of a layer is replace or detail.', 'layer', (json) => {
    json.layers[0].kind = 'overlay'
  }),
  refused('texture', 'Textures of layers exist.', 'textureInfo', (json) => {
    json.layers[0].normalTexture.index = 99
  }),
  refused('sizes', 'All textures of one kind have the same size.', 'layer', () => {}, {
    ...file,
    layers: [...file.layers, { name: 'age', normal: normals(4, SIDE / 2) }],
  }),
  refused('blood', 'Blood and occlusion of a layer share a texture.', 'Blood', () => {}, {
    ...file,
    layers: [{ ...file.layers[0], occlusion: noise(5), blood: noise(6), bloodAmplitude: 1 }],
  }),
  refused('onset', 'Onset shares the texture of occlusion or blood.', 'Onset', () => {}, {
    ...file,
    layers: [{ ...file.layers[0], blood: noise(5), bloodAmplitude: 1, onset: noise(6) }],
  }),
  refused('onset-roughness', 'Onset and roughness of a layer do not share a texture.', 'Onset', () => {}, {
    ...file,
    layers: [{ ...file.layers[0], roughness: ROUGH, onset: ROUGH }],
  }),
]
