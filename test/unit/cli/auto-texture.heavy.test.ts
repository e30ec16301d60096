import type { Document } from '@gltf-transform/core'
import { describe, expect, test } from 'vitest'
import { foldUvs } from '../../heads.ts'
import { skinOf } from './auto-changes.ts'
import {
  activationsOf,
  levelsApart,
  makeWrinkles,
  mapAttribute,
  plainFace,
  plainWrinkles,
} from './auto-variants.ts'
import { Workshop } from './workshop.ts'

const workshop = new Workshop()
const face = plainWrinkles(workshop)

describe('a shared texture', () => {
  test('of left and right gives one area for both sides, driven by shapes of both sides', async () => {
    const document = await plainFace()
    foldUvs(document)
    const made = await makeWrinkles(workshop, 'mirrored', document)
    expect(made.warned).toContain('left and right use the same texels')
    expect([...made.areas.keys()].filter((name) => /Left$|Right$/.test(name))).toEqual([])
    for (const region of ['foreheadOuter', 'crowsFeet', 'underEye', 'nasolabial', 'mouthCorner']) {
      // The area equals that of the left side of the unchanged face.
      expect(levelsApart(face().areas.get(`${region}Left`)!.data, made.areas.get(region)!.data)).toBeLessThan(
        2,
      )
      const [left, right, both] = ['Left', 'Right', 'Both'].map((side) =>
        activationsOf(made, sidesOf(POSE_OF[region]!, side)).get(region),
      ) as [number, number, number]
      expect(left).toBeCloseTo(right, 5)
      expect(both).toBeGreaterThan(left)
    }
  })

  test('of the limbs alone does not join the areas of the face', async () => {
    const document = await plainFace()
    mapAttribute(skinOf(document).listPrimitives(), 'TEXCOORD_0', ([u, v]) => [0.5 * u!, v!])
    addLimbs(document)
    const made = await makeWrinkles(workshop, 'limbs', document)
    expect(made.warned).not.toContain('left and right use the same texels')
    expect([...made.areas.keys()]).toEqual([...face().areas.keys()])
  })

  test('beyond its tile is reported', async () => {
    const document = await plainFace()
    mapAttribute(skinOf(document).listPrimitives(), 'TEXCOORD_0', ([u, v]) => [u! + 0.3, v!])
    const made = await makeWrinkles(workshop, 'crossing', document)
    expect(made.warned).toMatch(/\d+% of the skin crosses the edges of its texture/)
  })

  test('of other parts is reported', async () => {
    const document = await plainFace()
    mapAttribute(skinOf(document).listPrimitives(), 'TEXCOORD_0', ([u, v]) => [u!, 0.5 + Math.abs(v! - 0.5)])
    const made = await makeWrinkles(workshop, 'overlapping', document)
    expect(made.warned).toMatch(/\d+% of the texture is used twice: wrinkles there show in both places/)
  })
})

/** Adds two sheets to the skin, left and right of the body. Both use the same half of the texture. */
function addLimbs(document: Document): void {
  const mesh = skinOf(document)
  const skin = mesh.listPrimitives()[0]!
  const buffer = document.getRoot().listBuffers()[0]!
  const vectors = (type: 'VEC2' | 'VEC3', values: number[]) =>
    document.createAccessor().setType(type).setArray(new Float32Array(values)).setBuffer(buffer)
  const still = vectors('VEC3', Array(12).fill(0))
  for (const x of [-0.4, 0.3]) {
    const positions = [0, 1, 2, 3].flatMap((i) => [x + 0.1 * (i % 2), i > 1 ? 0.4 : 0, 0])
    const limb = document
      .createPrimitive()
      .setMaterial(skin.getMaterial())
      .setAttribute('POSITION', vectors('VEC3', positions))
      .setAttribute('NORMAL', vectors('VEC3', Array(4).fill([0, 0, 1]).flat()))
      .setAttribute('TEXCOORD_0', vectors('VEC2', [0.6, 1, 1, 1, 0.6, 0, 1, 0]))
      .setIndices(
        document
          .createAccessor()
          .setArray(new Uint16Array([0, 1, 3, 0, 3, 2]))
          .setBuffer(buffer),
      )
    for (const target of skin.listTargets())
      limb.addTarget(document.createPrimitiveTarget(target.getName()).setAttribute('POSITION', still))
    mesh.addPrimitive(limb)
  }
}

/** For each region, the ARKit shape that causes its wrinkles, without `Left` or `Right`. */
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
