import { createHash } from 'node:crypto'
import { readFileSync } from 'node:fs'
import type { Document } from '@gltf-transform/core'
import { draco, meshopt, quantize } from '@gltf-transform/functions'
import { MeshoptEncoder } from 'meshoptimizer/encoder'
import { beforeAll, describe, expect, test } from 'vitest'
import { BARE_FACES } from '../../bare-faces/bare-faces.ts'
import { FORMATS, rename, skinOf, withTargets } from './auto-changes.ts'
import {
  type AutoOutput,
  activationsApart,
  activationsOf,
  anyIO,
  areasApart,
  makeWrinkles,
  mapAttribute,
  meshOf,
  normalsApart,
  plainFace,
  plainWrinkles,
  wrinklesOf,
} from './auto-variants.ts'
import { toVRoid } from './vroid.ts'
import { Workshop } from './workshop.ts'

const workshop = new Workshop()
const face = plainWrinkles(workshop)

/** Tolerance of a comparison with the unchanged face: area weights in levels of 255, normals in degrees. */
interface Tolerance {
  levels: number
  degrees: number
}

/** Tolerance of activations, in comparison with the unchanged face. */
const ACTIVATIONS = 0.05

/** Tolerances if coordinates are rounded, which changes texels at the border of wrinkle lines. */
const ROUNDED = { levels: 1, degrees: 1 }
const QUANTISED = { levels: 5, degrees: 4 }

const TOLERANCES: Partial<Record<keyof typeof FORMATS, Tolerance>> = {
  quantised: QUANTISED,
  meshopt: QUANTISED,
  'placed by its node': ROUNDED,
  'placed by a skeleton': ROUNDED,
  'with a KHR_texture_transform': ROUNDED,
  'without a normal map, with integer coordinates that the transform of the base colour scales': QUANTISED,
}

/** Variants of the shipped face, which must all get the same wrinkles. */
const VARIANTS = Object.entries({
  ...FORMATS,
  'facing backwards': (document: Document) =>
    mapAttribute(withTargets(skinOf(document).listPrimitives()), 'POSITION', ([x, y, z]) => [-x!, y!, -z!]),
  'in another tile of the texture': (document: Document) =>
    mapAttribute(skinOf(document).listPrimitives(), 'TEXCOORD_0', ([u, v]) => [u! + 1, v! - 1]),
})

describe.each(VARIANTS)('a face %s', (name, change) => {
  const { levels, degrees } = TOLERANCES[name as keyof typeof FORMATS] ?? { levels: 0.1, degrees: 0.2 }

  test('gets the same wrinkles as the unchanged face, in a valid file', async () => {
    const document = await plainFace()
    await change(document)
    const made = await makeWrinkles(workshop, name, document)
    expect([...made.areas.keys()]).toEqual([...face().areas.keys()])
    expect(activationsApart(face(), made)).toBeLessThan(ACTIVATIONS)
    expect(areasApart(face(), made)).toBeLessThan(levels)
    expect(await normalsApart(face(), made)).toBeLessThan(degrees)
    expect(made.warned).toBe('')
    expect(await errorsOf(made.path)).toEqual([])
  })
})

test.each([
  ['quantised', 'KHR_mesh_quantization', quantize()],
  ['meshopt', 'EXT_meshopt_compression', meshopt({ encoder: MeshoptEncoder })],
  ['draco', 'KHR_draco_mesh_compression', draco()],
])('a %s file stays so, with the same meshes', async (name, extension, transform) => {
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
  expect(activationsApart(face(), made)).toBeLessThan(ACTIVATIONS)
})

describe("a face like VRoid Studio's", () => {
  let made: AutoOutput

  beforeAll(async () => {
    const document = await plainFace()
    toVRoid(document)
    made = await makeWrinkles(workshop, 'vroid', document)
  })

  test('is recognised by its shapes, and the drivers name them', () => {
    expect(made.warned).toContain('Fcl_BRW_Surprised, Fcl_BRW_Angry, Fcl_EYE_Joy_L, Fcl_EYE_Joy_R')
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

  test('has left and right on the correct sides, although it faces backwards', () => {
    for (const region of ['foreheadInner', 'foreheadOuter', 'glabella', 'crowsFeet', 'nasolabial'])
      for (const [side, other] of [
        ['Left', 'Right'],
        ['Right', 'Left'],
      ]) {
        const area = made.areas.get(`${region}${side}`)!.data
        expect(sharedBy(area, face().areas.get(`${region}${side}`)!.data)).toBeGreaterThan(0.75)
        expect(sharedBy(area, face().areas.get(`${region}${other}`)!.data)).toBeLessThan(0.25)
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

test.each(BARE_FACES)("$name has the same wrinkles as under ARKit's names", async ({ name, path }) => {
  const bare = await wrinklesOf(workshop, await copyOf(await plainFace(path), name))
  const renamed = await plainFace(path)
  rename(meshOf(renamed, 'face'), (name) => name.replace(/_L$/, 'Left').replace(/_R$/, 'Right'))
  const made = await makeWrinkles(workshop, `renamed ${name}`, renamed)
  expect([...made.areas.keys()]).toEqual([...bare.areas.keys()])
  expect(activationsApart(bare, made)).toBe(0)
  expect(areasApart(bare, made)).toBe(0)
})

/** Returns the fraction of an area's weight that another area covers too. */
function sharedBy(area: Uint8Array, other: Uint8Array): number {
  let [common, all] = [0, 0]
  for (let i = 0; i < area.length; i++) {
    common += Math.min(area[i]!, other[i]!)
    all += area[i]!
  }
  return common / all
}

/** Returns positions and indices of all primitives, as text. */
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

/** Returns errors of `furrow validate`. */
async function errorsOf(path: string): Promise<unknown[]> {
  workshop.printed = ''
  await workshop.run('validate', path, '--json')
  return JSON.parse(workshop.printed).findings.filter(
    ({ severity }: { severity: string }) => severity === 'error',
  )
}

async function copyOf(document: Document, name: string): Promise<string> {
  return workshop.write(`${name}.glb`, await (await anyIO()).writeBinary(document))
}
