import { readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { type Document, NodeIO } from '@gltf-transform/core'
import { ALL_EXTENSIONS } from '@gltf-transform/extensions'
import { mergeDocuments } from '@gltf-transform/functions'
import { Matrix4 } from 'three'
import { expect, test } from 'vitest'
import { jsonOf } from '../../glb.ts'
import { Workshop } from './workshop.ts'

const at = new Workshop()
const io = new NodeIO().registerExtensions(ALL_EXTENSIONS)
const [HAND, FACE] = ['hand', 'human'].map((name) =>
  fileURLToPath(new URL(`../../../faces/${name}.glb`, import.meta.url)),
) as [string, string]

/** Writes the shipped hand without its wrinkles and with a change. */
async function write(name: string, change: (document: Document) => void): Promise<string> {
  // The reader does not know the extension with the wrinkles, so it drops them.
  const document = await io.read(HAND)
  change(document)
  return at.write(name, await io.writeBinary(document))
}

function rename(document: Document, name: string): void {
  for (const mesh of document.getRoot().listMeshes()) if (mesh.getName() === 'skin') mesh.setName(name)
  for (const material of document.getRoot().listMaterials())
    if (material.getName() === 'skin') material.setName('')
}

const skinOf = (document: Document) => {
  const mesh = document
    .getRoot()
    .listMeshes()
    .find((one) => one.getName() === 'skin')!
  return mesh.listPrimitives()[0]!
}

/** Runs `furrow auto`, and returns its summary. */
async function auto(path: string, ...options: string[]) {
  at.printed = ''
  await at.run('auto', path, '-o', at.path('out.glb'), '--size', '512', '--force', '--json', ...options)
  return JSON.parse(at.printed)
}

interface Material {
  extensions?: { FURROW_wrinkle_maps?: { drivers: { type: string; joints: string[] }[] } }
}

const linesOf = ({ jointAreas }: { jointAreas: { lines: number }[] }) => jointAreas.map(({ lines }) => lines)

test('a hand of unknown material gets creases if the user says that it is skin', async () => {
  const path = await write('thing.glb', (document) => rename(document, 'Thing'))
  await at.fails(
    /mesh "Thing" may be skin, cloth or hard.*pass --kind "Thing=skin"/,
    'auto',
    path,
    '-o',
    at.path('out.glb'),
  )
  const { jointAreas, mesh } = await auto(path, '--kind', 'Thing=skin')
  expect(mesh).toBe('Thing')
  expect(jointAreas).toHaveLength(28)
})

test('a character with a face and a hand gets wrinkles from blendshapes and from joints', async () => {
  const document = await io.read(FACE)
  mergeDocuments(document, await io.read(HAND))
  const root = document.getRoot()
  const [first, ...others] = root.listBuffers()
  for (const accessor of root.listAccessors()) accessor.setBuffer(first!)
  for (const buffer of others) buffer.dispose()
  const [scene, other] = root.listScenes()
  for (const node of other!.listChildren()) scene!.addChild(node)
  other!.dispose()
  const path = at.write('both.glb', await io.writeBinary(document))
  const both = await auto(path)
  expect(both.isFace).toBe(true)
  expect(both.areas.length).toBeGreaterThan(10)
  expect(both.others.map(({ jointAreas }: { jointAreas: unknown[] }) => jointAreas.length)).toEqual([28])
  const face = await auto(path, '--regions', 'nose')
  expect(face.others).toEqual([])
})

test('a glove gets nothing, and the command says why', async () => {
  const path = await write('glove.glb', (document) => rename(document, 'Glove'))
  await at.fails('cloth folds at elbows, knees and waists only', 'auto', path, '-o', at.path('out.glb'))
})

test('inspect prints what is skin, and why', async () => {
  await at.run('inspect', await write('hand.glb', () => {}))
  expect(at.printed).toContain('skin  skin      skin  the name of the material contains "skin"  left hand')
  expect(at.printed).toMatch(/^skin +left hand +wrist\.L, finger1-\d\.L, .*\.\.\.$/m)
  expect(at.printed).toContain('generate wrinkles from its joints: furrow auto')
})

test('creases do not depend on how a file stores the skeleton', async () => {
  const plain = linesOf(await auto(await write('plain.glb', () => {})))
  const eight = await write('eight.glb', (document) => {
    const primitive = skinOf(document)
    // Moves the last two of four weights to a second set.
    for (const [semantic, type] of [
      ['JOINTS', Uint16Array],
      ['WEIGHTS', Float32Array],
    ] as const) {
      const first = primitive.getAttribute(`${semantic}_0`)!
      const sets = [0, 1].map(() => new type(4 * first.getCount()))
      for (let i = 0; i < first.getCount(); i++) {
        const own = first.getElement(i, [])
        for (let k = 0; k < 4; k++) sets[k >> 1]![4 * i + (k % 2)] = own[k]!
      }
      for (const [set, array] of sets.entries())
        primitive.setAttribute(
          `${semantic}_${set}`,
          document
            .createAccessor()
            .setType('VEC4')
            .setBuffer(document.getRoot().listBuffers()[0]!)
            .setArray(array),
        )
    }
  })
  expect(linesOf(await auto(eight))).toEqual(plain)
  const scaled = await write('scaled.glb', (document) => {
    const scale = new Matrix4().makeScale(100, 100, 100)
    for (const mesh of document.getRoot().listMeshes())
      for (const primitive of mesh.listPrimitives()) {
        const positions = primitive.getAttribute('POSITION')!
        positions.setArray(Float32Array.from(positions.getArray() as Float32Array, (value) => 100 * value))
      }
    for (const skin of document.getRoot().listSkins()) {
      const inverse = skin.getInverseBindMatrices()!
      for (let i = 0; i < inverse.getCount(); i++) {
        const matrix = new Matrix4().fromArray(inverse.getElement(i, []))
        // Joints see the mesh at its former size.
        inverse.setElement(i, matrix.multiply(scale.clone().invert()).toArray())
      }
    }
  })
  expect(linesOf(await auto(scaled))).toEqual(plain)
})

test('wrinkles in the file name its own joints', async () => {
  await auto(await write('plain.glb', () => {}))
  const { materials, nodes } = jsonOf(readFileSync(at.path('out.glb'))) as {
    materials: Material[]
    nodes: { name: string }[]
  }
  const names = nodes.map(({ name }) => name)
  const { drivers } = materials.find(({ extensions }) => extensions?.FURROW_wrinkle_maps)!.extensions!
    .FURROW_wrinkle_maps!
  const bones = drivers.filter(({ type }) => type === 'bone')
  expect(bones.length).toBeGreaterThan(28)
  for (const { joints } of bones) for (const joint of joints) expect(names).toContain(joint)
})
