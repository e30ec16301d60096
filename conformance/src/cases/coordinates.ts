import { image, noise, normals, SIDE } from '../map-image.ts'
import type { Sample, SampleFile } from '../sample.ts'

const LAYER = { name: 'skin', normal: normals(2) }
const base = normals(3)
const areas = [{ name: 'a', weights: noise(1), activation: 0.8 }]
const poses = [{ activations: { a: 0.8 } }]
const file: SampleFile = { base, layers: [LAYER], areas }

/** Returns an image whose blocks of 4 x 4 texels have one colour each. UASTC compression preserves such blocks. */
const blocks = (colour: (column: number, row: number) => readonly number[]) =>
  image(SIDE, (column, row) => colour(Math.floor(column / 4), Math.floor(row / 4)))

const blocky: SampleFile = {
  base,
  layers: [{ name: 'skin', normal: blocks((column, row) => [80 + 32 * column, 80 + 32 * row, 230]) }],
  areas: [{ ...areas[0], weights: blocks((column, row) => [64 * column + 16 * row, 0, 0]) }],
}

export const COORDINATE_SAMPLES: readonly Sample[] = [
  {
    name: 'second-coordinates',
    rule: "All maps use the texture coordinates of the material's normal map.",
    section: 'Implementation notes',
    file: { ...file, uvs: { set: 1 } },
    poses,
  },
  {
    name: 'transform',
    rule: "KHR_texture_transform of the material's normal map applies to all maps.",
    section: 'Implementation notes',
    file: { ...file, uvs: { transform: { scale: [0.5, 0.5], offset: [0.25, 0.125] } } },
    poses,
  },
  {
    name: 'tiles',
    rule: 'Texture coordinates outside 0..1 repeat, independent of samplers.',
    section: 'Implementation notes',
    file: { layers: [LAYER], areas, uvs: { offset: [-2.5, 3.25] } },
    poses,
  },
  {
    name: 'two-meshes',
    rule: 'Meshes that share a material share its wrinkles.',
    section: 'FURROW_wrinkle_maps',
    file: { ...file, isHalved: true },
    poses,
  },
  ...(['quantized', 'meshopt', 'draco'] as const).map((storage) => ({
    name: storage,
    rule: {
      quantized: 'Meshes can be quantised (KHR_mesh_quantization).',
      meshopt: 'Meshes can be compressed by EXT_meshopt_compression.',
      draco: 'Meshes can be compressed by KHR_draco_mesh_compression.',
    }[storage],
    section: 'Dependencies',
    file: { ...file, storage },
    poses,
  })),
  {
    name: 'ktx2',
    rule: 'Maps and areas can be slices of KTX 2 texture arrays (UASTC).',
    section: 'Texture arrays',
    file: { ...blocky, storage: 'ktx2' },
    poses,
  },
]
