import { readFileSync, writeFileSync } from 'node:fs'
import { NodeIO } from '@gltf-transform/core'
import { beforeAll, describe, expect, it } from 'vitest'
import { accessorsOf } from '../../accessors.ts'
import { unit } from '../../vectors.ts'
import {
  COLUMNS,
  corner,
  exact,
  HIGH,
  LOW,
  mikkFrame,
  ownFrame,
  placeOf,
  ROWS,
  readPixels,
  screenFrame,
  TILT,
  worst,
} from './exact-sphere.ts'
import { globe, icosphere, quad, writeGlb } from './spheres.ts'
import { bench } from './workshop.ts'

const at = bench('bake')
const { file, run, fails } = at
const report = () => JSON.parse(at.printed.trim().split('\n').at(-1)!)
const CAGE = ['--cage', '8']
const CLOSE = ['--size', '128', ...CAGE]

const plain = globe(LOW, COLUMNS, ROWS)
const tilted = globe(LOW, COLUMNS, ROWS, { tilt: TILT })
const mirrored = globe(LOW, COLUMNS, ROWS, { tilt: TILT, mirrored: true })

beforeAll(async () => {
  const ball = icosphere(HIGH, 5)
  await writeGlb(file('ball.glb'), { ball })
  const north = ball.indices.filter((_, i) => {
    const first = i - (i % 3)
    return [0, 1, 2].every((k) => ball.positions[3 * ball.indices[first + k]! + 1]! > 0)
  })
  await writeGlb(file('half.glb'), { ball: { ...ball, indices: north } })
  const { normals: _, ...facets } = ball
  await writeGlb(file('facets.glb'), { facets })
  const easts = (sign: number) =>
    Array.from({ length: tilted.normals.length / 3 }, (_, i) => {
      const n = corner(tilted.normals, i)
      return [...unit([sign * n[2], 0, -sign * n[0]]), sign]
    }).flat()
  await writeGlb(file('plain.glb'), { plain })
  await writeGlb(file('tilted.glb'), { tilted })
  await writeGlb(file('mirrored.glb'), { mirrored })
  await writeGlb(file('own.glb'), { own: { ...tilted, tangents: easts(1) } })
  await writeGlb(file('own-mirrored.glb'), { own: { ...mirrored, tangents: easts(-1) } })
})

describe('furrow bake: a sphere of 20480 triangles onto one of 576', () => {
  it.each([
    ['plain', plain, 'mikktspace', mikkFrame(1)],
    ['tilted', tilted, 'mikktspace', mikkFrame(1)],
    ['mirrored', mirrored, 'mikktspace', mikkFrame(-1)],
    ['own', tilted, 'of the mesh', ownFrame(1)],
    ['own-mirrored', mirrored, 'of the mesh', ownFrame(-1)],
    ['tilted', tilted, 'derivative', screenFrame],
    ['mirrored', mirrored, 'derivative', screenFrame],
  ] as const)('%s: within 0.5 degrees of the exact normal', async (name, shape, tangents, frame) => {
    const out = file(`${name}-${tangents[0]}.png`)
    const kind = tangents === 'of the mesh' ? [] : ['--tangents', tangents]
    // Takes one sample per texel. The derivative frame differs between triangles, so a mean across an edge fits neither triangle.
    if (tangents === 'derivative') kind.push('--samples', '1')
    await run(file('ball.glb'), file(`${name}.glb`), '-o', out, ...CLOSE, ...kind, '--json')
    expect(report()).toMatchObject({
      files: [out],
      size: 128,
      tangents,
      triangles: { high: 20480, low: 576 },
      cageMm: 8,
      misses: 0,
      emptyTexels: 0,
    })
    const { angle, tilted } = await worst(out, shape, frame)
    expect(angle).toBeLessThan(0.5)
    // The map must correct normals, because those of this mesh are tilted.
    if (name !== 'plain') expect(tilted).toBeGreaterThan(10)
  })

  it('is more accurate with 16 bits, and prints the scale of heights', async () => {
    const outputs = ['-o', file('wide.png'), '--height', file('height.png'), '--bits', '16']
    await run(file('ball.glb'), file('tilted.glb'), ...outputs, ...CLOSE)
    expect((await worst(file('wide.png'), tilted, mikkFrame(1))).angle).toBeLessThan(0.15)
    expect(at.printed).toContain('height.png: 32768 = 0 mm, 1000 steps = 1 mm')
    const { values, width, channels } = await readPixels(file('height.png'))
    expect(channels).toBe(1)
    for (const [x, y] of [
      [20, 20],
      [64, 64],
      [90, 33],
      [101, 110],
    ] as const) {
      const place = placeOf(tilted, (x + 0.5) / width, (y + 0.5) / width)!
      const mm = (values[y * width + x]! - 32768) / 1000
      expect(mm).toBeCloseTo(1000 * exact(tilted, place).height, 1)
      expect(mm).toBeGreaterThan(2.9)
    }
  })

  it('extends the islands by the margin, and no further', async () => {
    await run(file('ball.glb'), file('tilted.glb'), '-o', file('edge.png'), '--size', '128', '--margin', '3')
    const { values } = await readPixels(file('edge.png'))
    const texel = (x: number) => [...values.subarray(3 * (64 * 128 + x), 3 * (64 * 128 + x) + 3)]
    // The island begins at texel 6, and the margin is 3 texels.
    expect(texel(3)[0]! - texel(6)[0]!).toBeLessThan(4)
    expect(texel(3)).not.toEqual([128, 128, 255])
    expect(texel(2)).toEqual([128, 128, 255])
  })

  it('counts the rays without a hit', async () => {
    const args = [file('half.glb'), file('plain.glb'), '-o', file('half.png'), '--size', '64', ...CAGE]
    await run(...args, '--json')
    const { samples, misses, emptyTexels } = report()
    expect(samples).toBeGreaterThan(4 * 57 * 57)
    expect(misses / samples).toBeCloseTo(0.5, 1)
    expect(emptyTexels).toBeGreaterThan(1400)
    await run(...args)
    expect(at.printed).toMatch(/; \d+ of \d+ rays missed \((49|50|51|52)\.\d\d%\), \d+ texels had no hit/)
  })

  it('bakes the facets of a sculpt without normals, and warns about it', async () => {
    await run(file('facets.glb'), file('plain.glb'), '-o', file('facets.png'), '--size', '32')
    expect(at.warned).toContain('has no normals, so its facets are visible')
  })

  it('computes the exact occlusion of a floor beside a wall', async () => {
    // At distance d, an endless wall of height h hides `(1 - d / sqrt(d * d + h * h)) / 2` of the cosine-weighted sky.
    const floor = quad([0, 0, 0], [0, 0, 0.2], [0.2, 0, 0])
    const wide = quad([-1, 0, -20], [0, 0, 40], [2, 0, 0])
    const wall = quad([0, -0.01, 20], [0, 0, -40], [0, 0.11, 0])
    await writeGlb(file('floor.glb'), { floor })
    await writeGlb(file('wall.glb'), { wide, wall })
    const [ao, again] = [file('ao.png'), file('again.png')]
    for (const out of [ao, again]) {
      const args = ['--size', '32', '--rays', '32', '--cage', '5']
      await run(file('wall.glb'), file('floor.glb'), '--occlusion', out, ...args)
    }
    expect(readFileSync(again).equals(readFileSync(ao))).toBe(true)
    const { values } = await readPixels(ao)
    // The distance from the wall grows upwards in the texture.
    for (const row of [4, 16, 27]) {
      const d = 0.2 * (1 - (row + 0.5) / 32)
      const open = 1 - (1 - d / Math.hypot(d, 0.1)) / 2
      const line = Array.from(values.subarray(32 * row, 32 * row + 32))
      const mean = line.reduce((sum, value) => sum + value, 0) / 32 / 255
      expect(mean).toBeCloseTo(open, 1.6)
    }
    await run(file('wall.glb'), file('floor.glb'), '--occlusion', ao, '--size', '32', '--reach', '1')
    expect((await readPixels(ao)).values[16 * 32]).toBe(255)
  })
})

describe('with several meshes', () => {
  it('bakes onto the mesh that blendshapes move, as furrow auto would choose', async () => {
    await writeGlb(file('several.glb'), { teeth: tilted, face: plain })
    const document = await new NodeIO().read(file('several.glb'))
    const root = document.getRoot()
    const face = root.listMeshes().find((mesh) => mesh.getName() === 'face')!
    const [primitive] = face.listPrimitives()
    const offsets = new Float32Array(3 * primitive!.getAttribute('POSITION')!.getCount()).fill(0.01)
    const moved = accessorsOf(document)('VEC3', offsets)
    primitive!.addTarget(document.createPrimitiveTarget('browInnerUp').setAttribute('POSITION', moved))
    for (const mesh of root.listMeshes()) {
      for (const part of mesh.listPrimitives()) part.setMaterial(document.createMaterial(mesh.getName()))
    }
    await new NodeIO().write(file('several.glb'), document)
    await run(file('ball.glb'), file('several.glb'), '-o', file('several.png'), '--size', '16', '--json')
    expect(report().mesh).toBe('face')
  })
})

describe('furrow bake fails and writes nothing for', () => {
  beforeAll(async () => {
    const { uvs: _, ...bare } = plain
    await writeGlb(file('bare.glb'), { bare })
    const { normals: __, ...rough } = plain
    await writeGlb(file('rough.glb'), { rough })
    await writeGlb(file('two.glb'), { left: plain, right: tilted })
    await writeGlb(file('far.glb'), { far: quad([9, 9, 9], [1, 0, 0], [0, 1, 0]) })
    await writeGlb(file('nan.glb'), {
      nan: { ...plain, positions: plain.positions.map((p, i) => (i === 7 ? NaN : p)) },
    })
    await writeGlb(file('dot.glb'), {
      dot: { ...plain, positions: plain.positions.map(() => 0.01) },
    })
    await writeGlb(file('spread.glb'), { spread: { ...plain, uvs: plain.uvs.map((t) => 1e4 * t) } })
    await writeGlb(file('point.glb'), { point: { ...plain, uvs: plain.uvs.map(() => 0.5) } })
    writeFileSync(file('text.glb'), 'no glTF')
  })

  it.each([
    ['no glTF', 'text', 'plain', 'it is text, not glTF'],
    ['no texture coordinates', 'ball', 'bare', 'has texture coordinates'],
    ['no normals', 'ball', 'rough', 'rough in '],
    ['two meshes', 'ball', 'two', 'allowed: left, right; name one with --mesh'],
    ['a sculpt elsewhere', 'far', 'plain', 'no ray hit the detailed surface'],
    ['no numbers', 'nan', 'plain', 'is at NaN, allowed: finite numbers'],
    ['triangles without area', 'ball', 'dot', 'cannot compute tangents for'],
    ['absurd UVs', 'ball', 'spread', 'a triangle is larger than the texture'],
    ['UVs in one point', 'ball', 'point', 'no triangle covers a texel'],
  ])('%s', async (_, sculpt, mesh, message) => {
    await fails(message, file(`${sculpt}.glb`), file(`${mesh}.glb`), '-o', file('x.png'), '--size', '32')
  })

  it.each([
    ['no output', [], 'no output, allowed: -o NORMAL.png, --height HEIGHT.png, --occlusion AO.png'],
    ['no such mesh', ['-o', file('x.png'), '--mesh', 'nose'], 'got "nose", allowed: plain'],
  ])('%s', (_, args, message) => fails(message, file('ball.glb'), file('plain.glb'), ...args))
})
