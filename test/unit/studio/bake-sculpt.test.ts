import { mkdtempSync, readFileSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import sharp from 'sharp'
import { afterAll, beforeAll, expect, it } from 'vitest'
import { bakeSculpt } from '../../../studio/src/export/bake-sculpt.ts'
import { globe, icosphere, writeGlb } from '../cli/spheres.ts'
import { bench } from '../cli/workshop.ts'

const SIZE = 64

const at = bench('bake')
const folder = mkdtempSync(join(tmpdir(), 'furrow-sculpt-'))
const read = (name: string) => ({ name, bytes: new Uint8Array(readFileSync(join(folder, name))) })

beforeAll(async () => {
  await writeGlb(join(folder, 'sculpt.glb'), { sculpt: icosphere(0.103, 3) })
  await writeGlb(join(folder, 'elsewhere.glb'), { sculpt: icosphere(0.01, 1) })
  await writeGlb(join(folder, 'face.glb'), { eye: icosphere(0.02, 1), skin: globe(0.1, 24, 12) })
})

afterAll(() => rmSync(folder, { recursive: true, force: true }))

it('makes the same normal map as `furrow bake` does from the same files', async () => {
  const output = at.file('normal.png')
  const options = ['-o', output, '--mesh', 'skin', '--size', `${SIZE}`, '--tangents', 'derivative']
  await at.run(join(folder, 'sculpt.glb'), join(folder, 'face.glb'), ...options)
  const steps: number[] = []
  const target = { face: read('face.glb'), mesh: 'skin', size: SIZE }
  const baked = await bakeSculpt(read('sculpt.glb'), target, (done, total) => steps.push(done / total))
  const [own, commands] = await Promise.all([baked, output].map((png) => sharp(png).raw().toBuffer()))
  expect(own.equals(commands)).toBe(true)
  expect(steps.at(-1)).toBe(1)
})

it('refuses a sculpt that is not at the skin, with a message of one line', async () => {
  const target = { face: read('face.glb'), mesh: 'skin', size: SIZE }
  await expect(bakeSculpt(read('elsewhere.glb'), target)).rejects.toThrow(
    /^bakeMaps: no ray hit .*; align both meshes/,
  )
})

it('refuses a file that is not a model, with a message of one line', async () => {
  const sculpt = { name: 'sculpt.png', bytes: new Uint8Array(40) }
  const target = { face: read('face.glb'), size: SIZE }
  await expect(bakeSculpt(sculpt, target)).rejects.toThrow(/^Studio: .*sculpt\.png/)
})
