import { createHash } from 'node:crypto'
import { readFileSync } from 'node:fs'
import type { Document, Mesh, Primitive } from '@gltf-transform/core'
import { draco, meshopt, quantize, sparse } from '@gltf-transform/functions'
import { MeshoptEncoder } from 'meshoptimizer/encoder'
import { beforeAll, describe, expect, test } from 'vitest'
import { findSkin } from '../../../packages/cli/src/auto/read-skin.ts'
import { validateCommand } from '../../../packages/cli/src/commands/validate.ts'
import { hasScan, SCAN } from '../../real-face/pack-scan.ts'
import {
  activationsApart,
  activationsOf,
  anyIO,
  areasApart,
  levelsApart,
  type Made,
  makeWrinkles,
  mapAttribute,
  meshOf,
  normalsApart,
  plainFace,
  targetNamesOf,
  wrinklesOf,
} from './auto-variants.ts'
import { toVRoid, VROID_SKIN } from './vroid.ts'
import { Workshop } from './workshop.ts'

const workshop = new Workshop()
let face: Made

beforeAll(async () => {
  face = await makeWrinkles(workshop, 'face', await plainFace())
})

const skinOf = (document: Document) => meshOf(document, 'skin')
const withTargets = (primitives: readonly Primitive[]) =>
  primitives.flatMap((one) => [one, ...one.listTargets()])

/** Each format is the same face: the wrinkles must be the same too. */
const VARIANTS: [string, { change: (document: Document) => unknown; levels?: number; degrees?: number }][] = [
  [
    'named with _L and _R, behind a prefix',
    {
      change: (d) =>
        rename(skinOf(d), (name) => `head.${name.replace(/Left$/, '_L').replace(/Right$/, '_R')}`),
    },
  ],
  ['with visemes and shapes of its own', { change: addShapes }],
  ['dense', { change: (d) => d.transform(dense) }],
  ['sparse', { change: (d) => d.transform(dense, sparse({ ratio: 1 })) }],
  ['quantised', { change: (d) => d.transform(quantize()), levels: 5, degrees: 4 }],
  [
    'meshopt',
    {
      change: async (d) => {
        await MeshoptEncoder.ready
        await d.transform(meshopt({ encoder: MeshoptEncoder, level: 'medium' }))
      },
      levels: 5,
      degrees: 4,
    },
  ],
  ['in two primitives of one material', { change: split }],
  ['placed by its node', { change: placeByNode, levels: 1, degrees: 1 }],
  ['placed by a skeleton', { change: placeBySkeleton, levels: 1, degrees: 1 }],
  [
    'facing backwards',
    {
      change: (d) =>
        mapAttribute(withTargets(skinOf(d).listPrimitives()), 'POSITION', ([x, y, z]) => [-x!, y!, -z!]),
    },
  ],
  [
    'in another tile of the texture',
    { change: (d) => mapAttribute(skinOf(d).listPrimitives(), 'TEXCOORD_0', ([u, v]) => [u! + 1, v! - 1]) },
  ],
]

describe.each(VARIANTS)('a face %s', (name, { change, levels = 0.1, degrees = 0.2 }) => {
  test('gets the wrinkles of the plain one, in a file that is valid', async () => {
    const document = await plainFace()
    await change(document)
    const made = await makeWrinkles(workshop, name, document)
    expect([...made.areas.keys()]).toEqual([...face.areas.keys()])
    expect(activationsApart(face, made)).toBeLessThan(0.05)
    expect(areasApart(face, made)).toBeLessThan(levels)
    expect(await normalsApart(face, made)).toBeLessThan(degrees)
    expect(made.warned).toBe('')
    expect(await errorsOf(made.path)).toEqual([])
  })
})

test.each([
  ['quantised', 'KHR_mesh_quantization', quantize()],
  ['meshopt', 'EXT_meshopt_compression', meshopt({ encoder: MeshoptEncoder })],
  ['draco', 'KHR_draco_mesh_compression', draco()],
])('a file that is %s stays so, and holds the same meshes', async (name, extension, transform) => {
  await MeshoptEncoder.ready
  const made = await makeWrinkles(workshop, `stays ${name}`, await (await plainFace()).transform(transform))
  const [before, after] = await Promise.all(
    [made.plain, made.path].map(async (path) => (await anyIO()).binaryToJSON(readFileSync(path))),
  )
  expect(after!.json.extensionsRequired).toContain(extension)
  expect(after!.json.meshes).toEqual(before!.json.meshes)
  const shapes = await Promise.all(
    [made.plain, made.path].map(async (path) => shapesOf(await plainFace(path))),
  )
  expect(shapes[0]!.length).toBeGreaterThan(5)
  expect(shapes[1]).toEqual(shapes[0])
  expect(activationsApart(face, made)).toBeLessThan(0.05)
})

describe('a face in the manner of VRoid Studio', () => {
  let made: Made

  beforeAll(async () => {
    const document = await plainFace()
    toVRoid(document)
    made = await makeWrinkles(workshop, 'vroid', document)
  })

  test('is recognised by its own shapes, which are named', () => {
    expect(made.warned).toContain('Fcl_BRW_Surprised, Fcl_BRW_Angry, Fcl_EYE_Close_L, Fcl_EYE_Close_R')
    expect(made.warned).toContain("stand in for ARKit's shapes")
    const names = [...made.areas.keys()]
    for (const region of [
      'foreheadInner',
      'foreheadOuter',
      'glabella',
      'crowsFeet',
      'underEye',
      'nasolabial',
    ])
      expect(names).toEqual(expect.arrayContaining([`${region}Left`, `${region}Right`]))
  })

  test('has its left on its left, though it looks backwards', () => {
    for (const region of ['foreheadInner', 'foreheadOuter', 'glabella', 'crowsFeet', 'nasolabial'])
      for (const [side, other] of [
        ['Left', 'Right'],
        ['Right', 'Left'],
      ]) {
        const area = made.areas.get(`${region}${side}`)!.data
        expect(sharedBy(area, face.areas.get(`${region}${side}`)!.data)).toBeGreaterThan(0.75)
        expect(sharedBy(area, face.areas.get(`${region}${other}`)!.data)).toBeLessThan(0.25)
      }
  })

  test('wrinkles by its expressions', () => {
    const [surprised, angry, closed] = ['Fcl_BRW_Surprised', 'Fcl_BRW_Angry', 'Fcl_EYE_Joy_L'].map((shape) =>
      activationsOf(made, { [shape]: 1 }),
    ) as [Map<string, number>, Map<string, number>, Map<string, number>]
    for (const side of ['Left', 'Right']) {
      expect(surprised.get(`foreheadInner${side}`)).toBeGreaterThan(0.8)
      expect(surprised.get(`glabella${side}`)).toBeLessThan(0.2)
      expect(angry.get(`glabella${side}`)).toBeGreaterThan(0.8)
      expect(angry.get(`foreheadInner${side}`)).toBe(0)
    }
    expect(closed.get('crowsFeetLeft')).toBeGreaterThan(0.6)
    expect(closed.get('crowsFeetRight')).toBeLessThan(0.05)
  })
})

describe('the skin that is taken', () => {
  test.each([
    ['the shipped face', () => plainFace(), 'skin', 'skin'],
    [
      'one in the manner of VRoid Studio',
      async () => {
        const document = await plainFace()
        toVRoid(document)
        return document
      },
      'Face',
      VROID_SKIN,
    ],
    [
      'clothes, eyes and teeth that have all shapes, though they move little or with none that tell',
      async () => {
        const document = await plainFace()
        for (const name of ['eye-left', 'teeth-lower', 'brows', 'lashes']) lendShapes(document, name)
        lendShapes(document, 'shirt', 'jawOpen')
        return document
      },
      'skin',
      'skin',
    ],
    ...(hasScan ? ([['the scan', () => plainFace(SCAN), 'face', 'face']] as const) : []),
  ] as const)('is that of %s', async (_, read, mesh, material) => {
    const found = findSkin(await read(), 'face.glb', 'test')
    expect([found.meshName, found.materialName]).toEqual([mesh, material])
    expect(found.reason).toMatch(/^\d+% of what brows, lids and mouth move$/)
    expect(Number.parseInt(found.reason, 10)).toBeGreaterThan(50)
  })
})

test('the scan gets the wrinkles that it has under names of ARKit', { skip: !hasScan }, async () => {
  const scan = await wrinklesOf(workshop, await copyOf(await plainFace(SCAN), 'scan'))
  const renamed = await plainFace(SCAN)
  rename(meshOf(renamed, 'face'), (name) => name.replace(/_L$/, 'Left').replace(/_R$/, 'Right'))
  const made = await makeWrinkles(workshop, 'renamed scan', renamed)
  expect([...made.areas.keys()]).toEqual([...scan.areas.keys()])
  expect(activationsApart(scan, made)).toBe(0)
  expect(areasApart(scan, made)).toBe(0)
})

describe('a texture that is used twice', () => {
  test('by left and right: both sides have one area, driven by both', async () => {
    const document = await plainFace()
    mapAttribute(skinOf(document).listPrimitives(), 'TEXCOORD_0', ([u, v]) => [0.5 + Math.abs(u! - 0.5), v!])
    const made = await makeWrinkles(workshop, 'mirrored', document)
    expect(made.warned).toContain('left and right share their texels')
    expect([...made.areas.keys()].filter((name) => /Left$|Right$/.test(name))).toEqual([])
    for (const region of ['foreheadOuter', 'crowsFeet', 'underEye', 'nasolabial', 'mouthCorner']) {
      // Drawn once, where the left side of the plain face has it.
      expect(levelsApart(face.areas.get(`${region}Left`)!.data, made.areas.get(region)!.data)).toBeLessThan(2)
      const [left, right, both] = ['Left', 'Right', 'Both'].map((side) =>
        activationsOf(made, sidesOf(POSE_OF[region]!, side)).get(region),
      ) as [number, number, number]
      expect(left).toBeCloseTo(right, 5)
      expect(both).toBeGreaterThan(left)
    }
  })

  test('by other parts: it is said', async () => {
    const document = await plainFace()
    mapAttribute(skinOf(document).listPrimitives(), 'TEXCOORD_0', ([u, v]) => [u!, 0.5 + Math.abs(v! - 0.5)])
    const made = await makeWrinkles(workshop, 'overlapping', document)
    expect(made.warned).toMatch(/\d+% of the texture is used twice: what creases one place creases the other/)
  })
})

/** What creases a region on a side. */
const POSE_OF: Readonly<Record<string, string>> = {
  foreheadOuter: 'browOuterUp',
  crowsFeet: 'cheekSquint',
  underEye: 'cheekSquint',
  nasolabial: 'mouthSmile',
  mouthCorner: 'mouthSmile',
}

function sidesOf(shape: string, side: string): Record<string, number> {
  const names = side === 'Both' ? [`${shape}Left`, `${shape}Right`] : [`${shape}${side}`]
  return Object.fromEntries(names.map((name) => [name, 0.8]))
}

/** The part of an area's weight that another one has too. */
function sharedBy(area: Uint8Array, other: Uint8Array): number {
  let [common, all] = [0, 0]
  for (let i = 0; i < area.length; i++) {
    common += Math.min(area[i]!, other[i]!)
    all += area[i]!
  }
  return common / all
}

/** Positions and indices of all primitives, as they are read. */
function shapesOf(document: Document): string[] {
  return document
    .getRoot()
    .listMeshes()
    .flatMap((mesh) => mesh.listPrimitives())
    .map((primitive) =>
      [primitive.getAttribute('POSITION'), primitive.getIndices()]
        .map((accessor) =>
          createHash('sha256').update(Buffer.from(accessor!.getArray()!.buffer)).digest('hex'),
        )
        .join(' '),
    )
}

/** Errors that `furrow validate` finds. */
async function errorsOf(path: string): Promise<unknown[]> {
  workshop.printed = ''
  await workshop.run(validateCommand, path, '--json')
  return JSON.parse(workshop.printed).findings.filter(
    ({ severity }: { severity: string }) => severity === 'error',
  )
}

async function copyOf(document: Document, name: string): Promise<string> {
  return workshop.write(`${name}.glb`, await (await anyIO()).writeBinary(document))
}

/** Gives a mesh all shapes of the skin, or one; each moves it by a millimetre. */
function lendShapes(document: Document, name: string, only?: string): void {
  const mesh = meshOf(document, name)
  const names = only ? [only] : targetNamesOf(skinOf(document))
  const [primitive] = mesh.listPrimitives()
  const count = primitive!.getAttribute('POSITION')!.getCount()
  if (!primitive!.getAttribute('TEXCOORD_0')) {
    const uvs = Float32Array.from({ length: 2 * count }, (_, i) => (i % 7) / 7)
    primitive!.setAttribute('TEXCOORD_0', document.createAccessor().setType('VEC2').setArray(uvs))
  }
  for (const target of primitive!.listTargets()) primitive!.removeTarget(target)
  const moved = document
    .createAccessor()
    .setType('VEC3')
    .setArray(new Float32Array(3 * count).fill(0.0005))
  for (const shape of names)
    primitive!.addTarget(document.createPrimitiveTarget(shape).setAttribute('POSITION', moved))
  mesh.setExtras({ targetNames: names })
}

function rename(mesh: Mesh, change: (name: string) => string): void {
  mesh.setExtras({ ...mesh.getExtras(), targetNames: targetNamesOf(mesh).map(change) })
}

/** Drops how targets are stored, not what they hold. */
function dense(document: Document): void {
  for (const accessor of document.getRoot().listAccessors()) accessor.setSparse(false)
}

/** Visemes as sums of other targets, shapes of names that say nothing, and one that moves nothing. */
function addShapes(document: Document): void {
  const mesh = skinOf(document)
  const names = targetNamesOf(mesh)
  const primitive = mesh.listPrimitives()[0]!
  const targets = primitive.listTargets()
  const buffer = document.getRoot().listBuffers()[0]!
  const add = (name: string, sum: Readonly<Record<string, number>>) => {
    const first = primitive.getAttribute('POSITION')!
    const values = new Float32Array(3 * first.getCount())
    for (const [shape, weight] of Object.entries(sum)) {
      const moved = targets[names.indexOf(shape)]!.getAttribute('POSITION')!
      const element: number[] = []
      for (let i = 0; i < moved.getCount(); i++) {
        moved.getElement(i, element)
        for (let k = 0; k < 3; k++) values[3 * i + k]! += weight * element[k]!
      }
    }
    const accessor = document.createAccessor().setType('VEC3').setArray(values).setBuffer(buffer)
    primitive.addTarget(document.createPrimitiveTarget(name).setAttribute('POSITION', accessor))
    mesh.setExtras({ ...mesh.getExtras(), targetNames: [...targetNamesOf(mesh), name] })
  }
  add('viseme_aa', { jawOpen: 0.6, mouthFunnel: 0.1 })
  add('viseme_PP', { mouthClose: 0.3, mouthPressLeft: 0.5, mouthPressRight: 0.5 })
  add('viseme_O', { mouthFunnel: 0.7, jawOpen: 0.2 })
  add('Key 57', { jawForward: 0.5 })
  add('unused', {})
  mesh.setWeights([])
}

/** Every other triangle in a primitive of its own. */
function split(document: Document): void {
  const mesh = skinOf(document)
  const first = mesh.listPrimitives()[0]!
  const corners = [...first.getIndices()!.getArray()!]
  const second = first.clone()
  for (const [half, primitive] of [first, second].entries()) {
    const own = corners.filter((_, i) => Math.floor(i / 3) % 2 === half)
    const indices = document.createAccessor().setType('SCALAR').setArray(Uint32Array.from(own))
    primitive.setIndices(indices.setBuffer(document.getRoot().listBuffers()[0]!))
  }
  mesh.addPrimitive(second)
}

/** In centimetres, turned and moved; the node makes up for it. */
function placeByNode(document: Document): void {
  const mesh = skinOf(document)
  const node = mesh.listParents().find((parent) => parent.propertyType === 'Node')! as ReturnType<
    Document['createNode']
  >
  mapAttribute(
    mesh.listPrimitives().flatMap((one) => one.listTargets()),
    'POSITION',
    ([x, y, z]) => [100 * x!, -100 * z!, 100 * y!],
  )
  mapAttribute(mesh.listPrimitives(), 'POSITION', ([x, y, z]) => [100 * x! + 7, -100 * z!, 100 * y! - 20])
  node
    .setScale([0.01, 0.01, 0.01])
    .setRotation([-Math.SQRT1_2, 0, 0, Math.SQRT1_2])
    .setTranslation([-0.07, -0.2, 0])
}

/** In centimetres, skinned to one joint whose inverse bind matrix makes up for it; the node itself is moved, which must not matter. */
function placeBySkeleton(document: Document): void {
  const mesh = skinOf(document)
  const node = mesh.listParents().find((parent) => parent.propertyType === 'Node')! as ReturnType<
    Document['createNode']
  >
  mapAttribute(withTargets(mesh.listPrimitives()), 'POSITION', ([x, y, z]) => [100 * x!, 100 * y!, 100 * z!])
  const buffer = document.getRoot().listBuffers()[0]!
  const joint = document.createNode('head').setTranslation([0, 1.5, 0])
  document.getRoot().listScenes()[0]!.addChild(joint)
  const inverse = [0.01, 0, 0, 0, 0, 0.01, 0, 0, 0, 0, 0.01, 0, 0, -1.5, 0, 1]
  const matrices = document
    .createAccessor()
    .setType('MAT4')
    .setArray(Float32Array.from(inverse))
    .setBuffer(buffer)
  node
    .setSkin(document.createSkin().addJoint(joint).setInverseBindMatrices(matrices))
    .setTranslation([3, 0, 0])
  for (const primitive of mesh.listPrimitives()) {
    const count = primitive.getAttribute('POSITION')!.getCount()
    const of = (array: Uint8Array | Float32Array) =>
      document.createAccessor().setType('VEC4').setArray(array).setBuffer(buffer)
    primitive.setAttribute('JOINTS_0', of(new Uint8Array(4 * count)))
    primitive.setAttribute(
      'WEIGHTS_0',
      of(Float32Array.from({ length: 4 * count }, (_, i) => (i % 4 === 0 ? 1 : 0))),
    )
  }
}
