import { mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { Document, Logger, NodeIO, type Transform } from '@gltf-transform/core'
import { ALL_EXTENSIONS } from '@gltf-transform/extensions'
import { draco, meshopt, quantize, sparse } from '@gltf-transform/functions'
import draco3d from 'draco3d'
import { MeshoptDecoder, MeshoptEncoder } from 'meshoptimizer'
import sharp from 'sharp'
import { packCommand } from '../../packages/cli/src/commands/pack.ts'
import { accessorsOf } from '../accessors.ts'
import { quietly } from './quietly.ts'

/** Number of quads along each side of the face. */
const GRID = 8
/** Radius and height of the face, metres. */
const RADIUS = 0.075
const HEIGHT = 0.2
/** Width and height of the face's UV island, in texture coordinates. Small, because `auto` draws every texel of the island. */
const ISLAND = 0.5
/** Width and height of the face's images, texels. */
const SIDE = 64

/** Centre of each blendshape on the skin (`x`, `y`) and its displacement at the centre (`across`, `up`), metres. */
const SHAPES: Record<string, { x: number; y: number; across: number; up: number }> = {
  browInnerUp: { x: 0, y: 0.04, across: 0, up: 0.01 },
  browDownLeft: { x: 0.02, y: 0.04, across: -0.002, up: -0.006 },
  eyeBlinkLeft: { x: 0.032, y: 0.02, across: 0, up: -0.006 },
  eyeBlinkRight: { x: -0.032, y: 0.02, across: 0, up: -0.006 },
  mouthSmileLeft: { x: 0.026, y: -0.045, across: 0.008, up: 0.01 },
  mouthSmileRight: { x: -0.026, y: -0.045, across: -0.008, up: 0.01 },
}
/** Radius at which the displacement of a blendshape has fallen to 1/e, metres. */
const SHAPE_RADIUS = 0.02
const LAYERS = ['age', 'expression']
const AREAS = ['brow', 'cheek', 'chin', 'eye', 'nose']

/** Small valid files that the fuzzer damages. Each has features that the others lack. */
export interface Bases {
  faces: Map<string, Buffer>
  /** Bytes by path: the input files of `furrow pack` without the face, plus a strokes document. */
  folder: Map<string, Buffer>
  strokes: Buffer
  array: Buffer
  height: Buffer
}

export async function writeBases(root: string): Promise<void> {
  const write = (name: string, bytes: Uint8Array | string) => {
    mkdirSync(join(root, name, '..'), { recursive: true })
    writeFileSync(join(root, name), bytes)
  }
  for (const [name, bytes] of await makeFaces()) write(`faces/${name}.glb`, bytes)
  for (const [i, layer] of LAYERS.entries()) {
    write(`folder/layers/${layer}/normal.png`, await picture(i, 3))
    write(`folder/layers/${layer}/baseColor.png`, await picture(i + 4, 3))
  }
  for (const [i, area] of AREAS.entries()) write(`folder/areas/${area}.png`, await picture(i, 1))
  write('folder/wrinkles.json', JSON.stringify(WRINKLES))
  write('folder/strokes.json', JSON.stringify(STROKES))
  write('height.png', await picture(3, 1))
  for (const [name, face, ...options] of [
    ['packed', 'plain'],
    ['packed-array', 'skinned', '--ktx2'],
  ] as const) {
    const parameters = [join(root, 'folder'), '--face', join(root, `faces/${face}.glb`), ...options]
    const output = join(root, `faces/${name}.glb`)
    await quietly(() => packCommand.parseAsync([...parameters, '-o', output], { from: 'user' }))
  }
  write('array.ktx2', largestImage(readFileSync(join(root, 'faces/packed-array.glb'))))
}

/** Reads the files written by `writeBases`. */
export function readBases(root: string): Bases {
  const filesIn = (folder: string) => {
    const all = readdirSync(join(root, folder), { recursive: true, withFileTypes: true })
    const paths = all.filter((item) => item.isFile()).map((item) => join(item.parentPath, item.name))
    return new Map(
      paths.sort().map((path) => [path.slice(join(root, folder).length + 1), readFileSync(path)]),
    )
  }
  const read = (name: string) => readFileSync(join(root, name))
  return {
    faces: filesIn('faces'),
    folder: filesIn('folder'),
    strokes: read('folder/strokes.json'),
    array: read('array.ktx2'),
    height: read('height.png'),
  }
}

const WRINKLES = {
  version: 1,
  layers: LAYERS.map((name) => ({
    name,
    normal: `layers/${name}/normal.png`,
    baseColor: `layers/${name}/baseColor.png`,
  })),
  areas: AREAS.map((name, i) => ({
    name,
    image: `areas/${name}.png`,
    layer: i % 2 ? 'age' : 'expression',
    ...(i === 4 && { combine: 'max', activation: 0.5 }),
  })),
  drivers: [
    {
      type: 'morph',
      area: 'brow',
      targets: [
        {
          name: 'browInnerUp',
          weight: 0.5,
          curve: [
            [0, 0],
            [1, 1],
          ],
        },
      ],
    },
    { type: 'area', area: 'nose', areas: [{ name: 'brow', weight: -1 }], rule: 'sum' },
    {
      type: 'bone',
      area: 'chin',
      joints: ['head', 'jaw'],
      measure: 'angle',
      axis: [1, 0, 0],
      curve: [
        [0, 0],
        [1, 1],
      ],
    },
    { type: 'time', area: 'brow', attack: 0.1, release: 0.6 },
    { type: 'expression', name: 'doubt', targets: [{ name: 'browInnerUp', weight: 0.7 }], activations: [] },
  ],
}

const STROKES = {
  version: 1,
  size: 64,
  strokes: [
    {
      layer: 'age',
      group: 'brow',
      curve: 'spline',
      points: [
        [0.1, 0.1],
        [0.25, 0.12],
        [0.4, 0.1],
      ],
      width: 4,
      depth: 0.5,
      depths: [1, 0.5, 1],
    },
    {
      layer: 'expression',
      group: 'chin',
      points: [
        [0.1, 0.4],
        [0.4, 0.4],
      ],
      width: 3,
      depth: 0.4,
      taper: [0.1, 0.2],
      waviness: 0.5,
    },
  ],
  areas: [{ name: 'brow', shapes: [{ group: 'brow', radius: 6, feather: 8 }] }],
}

/** Makes a PNG of noise. An image of a single colour would be a special case, because tools may store it differently. */
function picture(seed: number, channels: 1 | 3): Promise<Uint8Array> {
  const data = Uint8Array.from({ length: channels * SIDE * SIDE }, (_, i) => (i * 37 + seed * 101) % 251)
  const image = sharp(data, { raw: { width: SIDE, height: SIDE, channels } })
  return (channels === 1 ? image.toColourspace('b-w') : image).png().toBuffer()
}

async function makeFaces(): Promise<[name: string, bytes: Uint8Array][]> {
  await MeshoptEncoder.ready
  const io = new NodeIO()
    .setLogger(new Logger(Logger.Verbosity.SILENT))
    .registerExtensions(ALL_EXTENSIONS)
    .registerDependencies({
      'meshopt.decoder': MeshoptDecoder,
      'meshopt.encoder': MeshoptEncoder,
      'draco3d.encoder': await draco3d.createEncoderModule(),
      'draco3d.decoder': await draco3d.createDecoderModule(),
    })
  const kinds: [name: string, isFace: boolean, transforms: Transform[]][] = [
    ['plain', false, []],
    ['skinned', true, [skin]],
    ['sparse', true, [sparse({ ratio: 1 })]],
    ['quantised', true, [skin, quantize()]],
    ['meshopt', true, [skin, meshopt({ encoder: MeshoptEncoder })]],
    ['draco', false, [draco()]],
  ]
  const faces: [string, Uint8Array][] = []
  for (const [name, isFace, transforms] of kinds) {
    const document = await faceDocument(isFace)
    await document.transform(...transforms)
    faces.push([name, await io.writeBinary(document)])
  }
  return faces
}

/**
 * Makes a document with the meshes `skin` and `eyes`. The skin is half a cylinder with a nose, and its blendshapes compress it.
 *
 * @param isFace true for blendshape names of ARKit. With meaningless names, `auto` places wrinkle lines by strain alone.
 */
async function faceDocument(isFace: boolean): Promise<Document> {
  const document = new Document().setLogger(new Logger(Logger.Verbosity.SILENT))
  const accessor = accessorsOf(document)
  const [positions, uvs, indices]: number[][] = [[], [], []]
  for (let row = 0; row <= GRID; row++) {
    for (let column = 0; column <= GRID; column++) {
      const [u, v] = [column / GRID, row / GRID]
      const angle = 0.9 * Math.PI * (u - 0.5)
      const nose = 0.02 * Math.exp(-(((u - 0.5) / 0.08) ** 2) - ((v - 0.55) / 0.08) ** 2)
      positions!.push(RADIUS * Math.sin(angle), HEIGHT * (0.5 - v), RADIUS * Math.cos(angle) + nose)
      uvs!.push(ISLAND * u, ISLAND * v)
      if (row === GRID || column === GRID) continue
      const i = row * (GRID + 1) + column
      indices!.push(i, i + GRID + 1, i + 1, i + 1, i + GRID + 1, i + GRID + 2)
    }
  }
  const material = document.createMaterial('skin')
  for (const [seed, set] of (['setNormalTexture', 'setBaseColorTexture'] as const).entries()) {
    const image = (await picture(seed, 3)) as Uint8Array<ArrayBuffer>
    material[set](document.createTexture(`skin ${seed}`).setImage(image).setMimeType('image/png'))
  }
  const up = Float32Array.from(positions!, (_, i) => (i % 3 === 2 ? 1 : 0))
  const primitive = document
    .createPrimitive()
    .setAttribute('POSITION', accessor('VEC3', Float32Array.from(positions!)))
    .setAttribute('NORMAL', accessor('VEC3', up))
    .setAttribute('TEXCOORD_0', accessor('VEC2', Float32Array.from(uvs!)))
    .setIndices(accessor('SCALAR', Uint16Array.from(indices!)))
    .setMaterial(material)
  const shapes = Object.entries(SHAPES).map(
    ([name, shape], i) => [isFace ? name : `fold ${i}`, shape] as const,
  )
  const targetNames = shapes.map(([name]) => name)
  const mesh = document.createMesh('skin').addPrimitive(primitive).setExtras({ targetNames })
  for (const [name, { x, y, across, up }] of shapes) {
    const offsets = new Float32Array(positions!.length)
    for (let i = 0; i < offsets.length; i += 3) {
      const distance = Math.hypot(positions![i]! - x, positions![i + 1]! - y)
      const weight = Math.exp(-((distance / SHAPE_RADIUS) ** 2))
      offsets.set([across * weight, up * weight], i)
    }
    primitive.addTarget(
      document.createPrimitiveTarget(name).setAttribute('POSITION', accessor('VEC3', offsets)),
    )
  }
  const eyes = document
    .createPrimitive()
    .setAttribute('POSITION', accessor('VEC3', Float32Array.of(0, 0, 0.06, 0.01, 0, 0.06, 0, 0.01, 0.06)))
    .setMaterial(document.createMaterial('eyes'))
  const scene = document.createScene()
  scene.addChild(document.createNode('skin').setMesh(mesh))
  scene.addChild(document.createNode('eyes').setMesh(document.createMesh('eyes').addPrimitive(eyes)))
  return document
}

/** Binds the face to two joints. */
function skin(document: Document): void {
  const accessor = accessorsOf(document)
  const [head, jaw] = [document.createNode('head'), document.createNode('jaw')]
  const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]
  const inverseBind = document
    .createAccessor()
    .setType('MAT4')
    .setArray(Float32Array.from([...identity, ...identity]))
    .setBuffer(document.getRoot().listBuffers()[0]!)
  const joints = document.createSkin().addJoint(head).addJoint(jaw).setInverseBindMatrices(inverseBind)
  const node = document.getRoot().listNodes()[0]!
  const primitive = node.getMesh()!.listPrimitives()[0]!
  const count = primitive.getAttribute('POSITION')!.getCount()
  primitive.setAttribute('JOINTS_0', accessor('VEC4', new Uint16Array(4 * count)))
  const weights = Float32Array.from({ length: 4 * count }, (_, i) => (i % 4 === 0 ? 1 : 0))
  primitive.setAttribute('WEIGHTS_0', accessor('VEC4', weights))
  document.getRoot().listScenes()[0]!.addChild(head.addChild(jaw))
  node.setSkin(joints)
}

interface View {
  byteOffset: number
  byteLength: number
}

/** Returns the bytes of the largest image in a `.glb`. */
function largestImage(glb: Buffer): Buffer {
  const length = glb.readUInt32LE(12)
  const json = JSON.parse(glb.toString('utf8', 20, 20 + length))
  const views = json.images.map(({ bufferView }: { bufferView: number }) => json.bufferViews[bufferView])
  const { byteOffset, byteLength } = views.reduce((a: View, b: View) => (a.byteLength > b.byteLength ? a : b))
  return glb.subarray(28 + length + byteOffset, 28 + length + byteOffset + byteLength)
}
