import { readFileSync } from 'node:fs'
import sharp from 'sharp'
import { describe, expect, it } from 'vitest'
import { inspectCommand } from '../../../packages/cli/src/commands/inspect.ts'
import { strokesCommand } from '../../../packages/cli/src/commands/strokes.ts'
import { uvCommand } from '../../../packages/cli/src/commands/uv.ts'
import { faceBytes, jsonOf, Workshop, withJson } from './workshop.ts'

const shop = new Workshop()

const POINTS = [
  [0.1, 0.8],
  [0.4, 0.9],
]

/** Two meshes, of which only the second moves. */
async function avatar(): Promise<string> {
  const face = await faceBytes(['teeth', 'head'])
  const json = jsonOf(face)
  delete json.meshes[0].primitives[0].targets
  return shop.write('avatar.glb', withJson(face, json))
}

describe('furrow uv', () => {
  it('draws the layout of the mesh that auto would choose, transparent where there is none', async () => {
    await shop.run(uvCommand, await avatar(), '-o', shop.path('uv.png'), '--size', '64')
    expect(shop.printed).toContain('uv.png: 64 x 64, mesh "head", material "head" (100% of what brows')
    const { data, info } = await sharp(shop.path('uv.png')).raw().toBuffer({ resolveWithObject: true })
    expect(info).toMatchObject({ width: 64, height: 64, channels: 4 })
    // Its triangle has the corners (0, 1), (1, 1) and (0, 0).
    const alpha = (x: number, y: number) => data[4 * (64 * y + x) + 3]
    expect(alpha(16, 48)).toBe(255)
    expect(alpha(48, 16)).toBe(0)
    const [red, green, blue] = data.subarray(4 * (64 * 32 + 32))
    expect(red).toBeGreaterThan(green + 40)
    expect(green).toBeGreaterThan(blue)
  })

  it('refuses triangles that lie on top of each other by the hundred', async () => {
    const face = await faceBytes(['head'])
    const json = jsonOf(face)
    const [primitive] = json.meshes[0].primitives
    json.meshes[0].primitives = Array(200).fill(primitive)
    const path = shop.write('piled.glb', withJson(face, json))
    await expect(shop.run(uvCommand, path, '-o', shop.path('uv.png'))).rejects.toThrow(
      'furrow uv: too many triangles of the skin lie on top of each other in its texture, got "200 times its size"',
    )
    await expect(shop.run(inspectCommand, path, '--sheet', shop.path('uv.png'))).rejects.toThrow(
      'furrow inspect: too many triangles',
    )
  })

  it('takes another mesh by name, and refuses one that is not there', async () => {
    const path = await avatar()
    await shop.run(uvCommand, path, '-o', shop.path('teeth.png'), '--mesh', 'teeth', '--json')
    expect(JSON.parse(shop.printed)).toMatchObject({ mesh: 'teeth', size: 2048 })
    const failure = await shop.failure(uvCommand, path, '-o', shop.path('x.png'), '--mesh', 'nose')
    expect(failure.message).toContain('furrow uv: no such mesh')
  })
})

describe('furrow inspect of a face without wrinkles', () => {
  it('lists its meshes and says what to do', async () => {
    await shop.run(inspectCommand, await avatar())
    expect(shop.printed).toContain('avatar.glb: no wrinkles')
    expect(shop.printed).toMatch(/^head +head +3 +1 +1: browInnerUp$/m)
    expect(shop.printed).toMatch(/^teeth +teeth +3 +1 +none$/m)
    expect(shop.printed).toContain('the skin is mesh "head", material "head"')
    expect(shop.printed).toContain(`furrow auto ${shop.path('avatar.glb')} -o wrinkled.glb`)
    shop.printed = ''
    await shop.run(inspectCommand, shop.path('avatar.glb'), '--json')
    expect(JSON.parse(shop.printed)).toMatchObject({ wrinkles: false, auto: true, skin: { mesh: 'head' } })
  })

  it('names a file so that the command can be pasted', async () => {
    const path = shop.write('my fäce.glb', readFileSync(await avatar()))
    await shop.run(inspectCommand, path)
    expect(shop.printed).toContain(`furrow auto "${path}" -o wrinkled.glb`)
  })

  it('says why auto cannot make any', async () => {
    const json = jsonOf(await faceBytes())
    for (const mesh of json.meshes) delete mesh.primitives[0].targets
    const still = shop.write('still.glb', withJson(await faceBytes(), json))
    await shop.run(inspectCommand, still)
    expect(shop.printed).toContain('no blendshape moves the skin: draw wrinkles (furrow strokes)')
    for (const mesh of json.meshes) delete mesh.primitives[0].attributes.TEXCOORD_0
    shop.printed = ''
    await shop.run(inspectCommand, shop.write('bare.glb', withJson(await faceBytes(), json)))
    expect(shop.printed).toContain('unwrap the face first')
  })

  it('draws its skin and UV layout as a sheet', async () => {
    await shop.run(inspectCommand, await avatar(), '--sheet', shop.path('sheet.png'))
    expect(shop.printed).toMatch(/sheet\.png: the skin and its UV layout\n$/)
    const { width, height } = await sharp(readFileSync(shop.path('sheet.png'))).metadata()
    expect([width, height]).toEqual([542, 302])
  })
})

describe('furrow strokes on an avatar', () => {
  it('finds the mesh that the blendshapes move', async () => {
    const strokes = shop.json('strokes.json', {
      version: 1,
      strokes: [{ points: POINTS, width: 4, depth: 0.5 }],
    })
    const path = await avatar()
    await shop.run(strokesCommand, strokes, '--face', path, '-o', shop.path('height.png'), '--size', '64')
    expect(shop.printed).toContain('height.png: 64 x 64')
  })
})
