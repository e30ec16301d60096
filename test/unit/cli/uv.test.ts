import { readFileSync } from 'node:fs'
import sharp from 'sharp'
import { describe, expect, it } from 'vitest'
import { editGlb } from '../../glb.ts'
import { ONE_LINE } from '../../strokes.ts'
import { faceBytes, stillTeeth, Workshop } from './workshop.ts'

const shop = new Workshop()

const avatar = async () => shop.write('avatar.glb', await stillTeeth())

describe('furrow uv', () => {
  it('draws the UV layout of the mesh that furrow auto would choose, transparent outside the islands', async () => {
    await shop.run('uv', await avatar(), '-o', shop.path('uv.png'), '--size', '64')
    expect(shop.printed).toContain(
      'uv.png: 64 x 64, mesh "head", material "head" (100% of the motion of brows',
    )
    const { data, info } = await sharp(shop.path('uv.png')).raw().toBuffer({ resolveWithObject: true })
    expect(info).toMatchObject({ width: 64, height: 64, channels: 4 })
    // The UVs of the triangle are (0, 1), (1, 1) and (0, 0).
    const alpha = (x: number, y: number) => data[4 * (64 * y + x) + 3]
    expect(alpha(16, 48)).toBe(255)
    expect(alpha(48, 16)).toBe(0)
    const [red, green, blue] = data.subarray(4 * (64 * 32 + 32))
    expect(red).toBeGreaterThan(green + 40)
    expect(green).toBeGreaterThan(blue)
  })

  it('refuses hundreds of overlapping triangles', async () => {
    const piled = editGlb(await faceBytes(['head']), ({ meshes }) => {
      meshes[0].primitives = Array(200).fill(meshes[0].primitives[0])
    })
    const path = shop.write('piled.glb', piled)
    const onTop = 'too many overlapping triangles in UV space, got "200 times the texture"'
    await shop.fails(onTop, 'uv', path, '-o', shop.path('x.png'))
    await shop.fails('too many overlapping triangles', 'inspect', path, '--sheet', shop.path('x.png'))
  })

  it('uses another mesh by name, and refuses a missing one', async () => {
    const path = await avatar()
    await shop.run('uv', path, '-o', shop.path('teeth.png'), '--mesh', 'teeth', '--json')
    expect(JSON.parse(shop.printed)).toMatchObject({ mesh: 'teeth', size: 2048 })
    await shop.fails('no such mesh', 'uv', path, '-o', shop.path('x.png'), '--mesh', 'nose')
  })
})

describe('furrow inspect of a face without wrinkles', () => {
  it('lists its meshes and suggests what to do', async () => {
    await shop.run('inspect', await avatar())
    expect(shop.printed).toContain('avatar.glb: no wrinkles')
    expect(shop.printed).toMatch(/^head +head +3 +1 +1: browInnerUp$/m)
    expect(shop.printed).toMatch(/^teeth +teeth +3 +1 +none$/m)
    expect(shop.printed).toContain('the skin is mesh "head", material "head"')
    expect(shop.printed).toContain(`furrow auto ${shop.path('avatar.glb')} -o wrinkled.glb`)
    const report = JSON.parse(await shop.output('inspect', shop.path('avatar.glb'), '--json'))
    expect(report).toMatchObject({ wrinkles: false, auto: true, skin: { mesh: 'head' } })
  })

  it('quotes a file name so that the command can be pasted', async () => {
    const path = shop.write('my fäce.glb', readFileSync(await avatar()))
    await shop.run('inspect', path)
    expect(shop.printed).toContain(`furrow auto "${path}" -o wrinkled.glb`)
  })

  it('explains why furrow auto cannot make wrinkles', async () => {
    const without = async (name: string, part: 'targets' | 'attributes') => {
      const edited = editGlb(await faceBytes(), ({ meshes }) => {
        for (const { primitives } of meshes) {
          if (part === 'attributes') delete primitives[0].attributes.TEXCOORD_0
          delete primitives[0].targets
        }
      })
      return shop.output('inspect', shop.write(name, edited))
    }
    const still = await without('still.glb', 'targets')
    expect(still).toContain('no blendshape moves the skin: draw wrinkles (furrow strokes)')
    expect(await without('bare.glb', 'attributes')).toContain('unwrap the face first')
  })

  it('draws its skin and UV layout into one picture', async () => {
    await shop.run('inspect', await avatar(), '--sheet', shop.path('sheet.png'))
    expect(shop.printed).toMatch(/sheet\.png: the skin and its UV layout\n$/)
    const { width, height } = await sharp(readFileSync(shop.path('sheet.png'))).metadata()
    expect([width, height]).toEqual([542, 302])
  })
})

describe('furrow strokes on an avatar', () => {
  it('finds the mesh that the blendshapes move', async () => {
    const strokes = shop.json('strokes.json', ONE_LINE)
    const path = await avatar()
    await shop.run('strokes', strokes, '--face', path, '-o', shop.path('height.png'), '--size', '64')
    expect(shop.printed).toContain('height.png: 64 x 64')
  })
})
