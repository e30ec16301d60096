import { readFileSync, writeFileSync } from 'node:fs'
import { expect, test } from 'vitest'
import { editGlb } from '../../glb.ts'
import { writeSheet } from './sheet.ts'
import { bench } from './workshop.ts'

const at = bench('auto')
const { file, fails } = at

async function write(name: string, edit: Parameters<typeof editGlb>[1] = () => {}): Promise<string> {
  writeFileSync(file(name), editGlb(readFileSync(await writeSheet(file(name))), edit))
  return file(name)
}

test.each([
  ['PNG', []],
  ['KTX 2', ['--ktx2']],
])('the printed cost equals that of inspect, as %s', async (_, options) => {
  const path = await write('plain.glb')
  await at.run(path, '-o', file('out.glb'), '--size', '512', '--json', '--force', ...options)
  const { cost } = JSON.parse(at.printed)
  const { gpu, influenceMapBytes, imageBytes, strokes } = JSON.parse(
    await at.shop.output('inspect', file('out.glb'), '--json'),
  )
  const isCompressed = options.length > 0
  expect(cost).toEqual({
    file: imageBytes + strokes.bytes,
    gpu: (isCompressed ? gpu.bits4 : gpu.uncompressed) + influenceMapBytes,
    phone: (isCompressed ? gpu.bits8 : gpu.uncompressed) + influenceMapBytes,
  })
})

test('a compressed avatar at 1024 texels takes at most 2 MB on the GPU, as counted by inspect', async () => {
  await at.run('faces/human.glb', '-o', file('small.glb'), '--replace', '--ktx2', '--json')
  const { cost, layers } = JSON.parse(at.printed)
  expect(cost.gpu).toBeLessThanOrEqual(2 * 1024 * 1024)
  expect(layers).toHaveLength(2)
  const { gpu, influenceMapBytes, imageBytes, strokes } = JSON.parse(
    await at.shop.output('inspect', file('small.glb'), '--json'),
  )
  expect(gpu.bits4 + influenceMapBytes).toBe(cost.gpu)
  expect(imageBytes + strokes.bytes).toBe(cost.file)
})

test('the cost of wrinkles, ways to reduce it, and tools that drop wrinkles are printed', async () => {
  await at.run(await write('plain.glb'), '-o', file('out.glb'), '--size', '512')
  expect(at.printed).toMatch(
    /wrinkles: [\d.]+ kB in the file, [\d.]+ kB on the GPU; --ktx2 or a smaller --size/,
  )
  expect(at.printed).toContain('register FurrowWrinkleMaps')
})

test('the cost of compressed wrinkles on a phone is printed too', async () => {
  await at.run(await write('plain.glb'), '-o', file('out.glb'), '--size', '512', '--ktx2', '--force')
  const [, desktop, phone] = /([\d.]+) kB on the GPU \(([\d.]+) kB on a phone, as ASTC\)/.exec(at.printed)!
  // Maps take twice the memory on phones; areas and the influence map take the same.
  expect(Number(phone)).toBeGreaterThan(1.5 * Number(desktop))
  expect(Number(phone)).toBeLessThan(2 * Number(desktop))
})

test('maps that are too large to compress are refused before the wrinkles are made', async () => {
  await fails('too many texels', 'never-read.glb', '-o', file('x.glb'), '--ktx2', '--size', '4096')
})

test.each<[string, (json: Json) => void, string]>([
  [
    'MToon of VRM 1',
    ({ materials }) => {
      materials[0]!.extensions = { VRMC_materials_mtoon: {}, KHR_materials_unlit: {} }
    },
    'is MToon: pages that register three-vrm draw wrinkles as lines',
  ],
  [
    'MToon of VRM 0',
    (json) => {
      unlit(json.materials[0]!)
      json.extensions = { VRM: { materialProperties: [{ shader: 'VRM/MToon' }] } }
    },
    'is MToon: pages that register three-vrm draw wrinkles as lines',
  ],
])('a warning names a material that is %s', async (_, edit, warning) => {
  await at.run(await write('odd.glb', edit as never), '-o', file('out.glb'), '--size', '512', '--force')
  expect(at.warned).toContain(warning)
})

test('a mesh without normals gets some, and validate accepts the result', async () => {
  const face = await write('flat.glb', (({ meshes }: Json) => {
    delete meshes[0]!.primitives[0]!.attributes!.NORMAL
  }) as never)
  await at.run(face, '-o', file('smooth.glb'), '--size', '512')
  expect(at.warned).toContain('the mesh has no normals; smooth normals were added')
  await at.shop.run('validate', file('smooth.glb'))
  expect(process.exitCode).toBeFalsy()
})

test('an unlit material is refused before the wrinkles are made', async () => {
  const message = 'the material "cloth" cannot show wrinkles: it is unlit (KHR_materials_unlit)'
  const face = await write('unlit.glb', (({ materials }: Json) => unlit(materials[0]!)) as never)
  await fails(message, face, '-o', file('unlit-out.glb'), '--size', '512')
})

test('a lit material is preferred to an unlit one that moves equally', async () => {
  const face = await write('two.glb', ((json: Json) => {
    const [primitive] = json.meshes[0]!.primitives
    unlit(json.materials[0]!)
    json.materials.push({ name: 'lit' })
    json.meshes.push({ ...json.meshes[0]!, name: 'second', primitives: [{ ...primitive, material: 1 }] })
    json.scenes[0]!.nodes.push(json.nodes.push({ mesh: 1 }) - 1)
  }) as never)
  await at.run(face, '-o', file('out.glb'), '--size', '512', '--json')
  expect(JSON.parse(at.printed).material).toBe('lit')
})

interface Json {
  materials: { name?: string; extensions?: object }[]
  meshes: { name?: string; primitives: { material?: number; attributes?: Record<string, number> }[] }[]
  nodes: { mesh?: number }[]
  scenes: { nodes: number[] }[]
  extensions?: object
}

function unlit(material: Json['materials'][number]): void {
  material.extensions = { KHR_materials_unlit: {} }
}
