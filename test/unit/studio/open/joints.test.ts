import { decodeGlb, documentOf, findSurfaces } from 'furrow-files'
import { Vector3 } from 'three'
import { expect, it } from 'vitest'
import type { OpenedAvatar } from '../../../../studio/src/open/avatar.ts'
import { skinSource } from '../../../../studio/src/open/skin-source.ts'
import { findSkins } from '../../../../studio/src/open/skins.ts'
import { autoSource } from '../../../../studio/src/open/surface.ts'
import { clearUp, signsOfUp, turnUpright } from '../../../../studio/src/open/upright.ts'
import { type SkinFileOptions, skinFile } from '../../../skin-file.ts'
import { RIGS, skeletonOf } from '../../author/auto/limbs/rigs.ts'
import { sleeve } from '../../author/auto/limbs/sleeve.ts'
import { torso } from '../../author/auto/limbs/torso.ts'
import { loadInNode } from '../../three/node-loader.ts'

const FILE: SkinFileOptions = {
  mesh: 'Arm',
  material: 'Shirt',
  animation: { joint: 'LeftForeArm', angles: [0, 1, 2.5] },
}

async function opened(bytes: Uint8Array) {
  const skins = await findSkins(await loadInNode(bytes), (problem) => expect(problem).toBe(''))
  return skinSource({ skins, skin: 0 } as unknown as OpenedAvatar)!
}

it('the studio reads the same skeleton as `furrow auto`, with the rotations of animations', async () => {
  const bytes = await skinFile(sleeve(), FILE)
  const document = await documentOf(decodeGlb(bytes, 'arm.glb', 'test'), 'arm.glb', 'test')
  const { skeleton } = findSurfaces(document, 'arm.glb', 'test', {}).surfaces[0]!.skin
  const { skin, surface, limbs } = await opened(bytes)
  expect(surface).toEqual({ kind: 'cloth', cloth: 'shirt' })
  expect(limbs).toEqual(['left elbow'])
  expect(skin.skeleton!.influences).toBe(skeleton!.influences)
  expect(Array.from(skin.skeleton!.indices)).toEqual(Array.from(skeleton!.indices))
  for (const [i, { name, parent, bind, rotations = [] }] of skeleton!.joints.entries()) {
    const own = skin.skeleton!.joints[i]!
    expect([own.name, own.parent]).toEqual([name, parent])
    expect(Math.max(...Array.from(bind, (value, k) => Math.abs(value - own.bind[k]!)))).toBeLessThan(1e-6)
    expect(own.rotations).toHaveLength(rotations.length)
    for (const [k, value] of Array.from(rotations).entries()) expect(own.rotations![k]).toBeCloseTo(value, 5)
  }
})

it.each([
  ['cloth by its name', 'Shirt', {}, { cloth: 'shirt', tubes: false }],
  [
    'cloth of another kind if the user says so',
    'Shirt',
    { cloth: 'denim' },
    { cloth: 'denim', tubes: false },
  ],
  ['skin if the user says so', 'Shirt', { kind: 'skin' }, { tubes: true }],
  ['nothing that joints fold if its kind is unknown', 'Shell', {}, undefined],
  ['nothing that joints fold if it is hard', 'Robot', {}, undefined],
] as const)('a sleeve is %s', async (_, material, settings, options) => {
  const source = await opened(await skinFile(sleeve(), { ...FILE, material }))
  expect(autoSource(source, settings)?.options).toEqual(options)
})

it.each([
  ['Mixamo', false],
  ['Mixamo', true],
  ['Rigify', true],
])('a body of %s stands upright, also if it lies in the file: %s', async (rig, isLying) => {
  const skin = { ...torso(), skeleton: { ...torso().skeleton!, joints: skeletonOf(RIGS[rig]!).joints } }
  const gltf = await loadInNode(await skinFile(skin, { mesh: 'Shell', material: 'Shell', isLying }))
  turnUpright(gltf)
  const isTurned = gltf.scene.quaternion.angleTo(gltf.scene.quaternion.clone().identity()) > 0.1
  expect(isTurned).toBe(isLying)
  gltf.scene.updateMatrixWorld(true)
  const [up] = signsOfUp((await findSkins(gltf, () => {}))[0]!.rest.joints!)
  expect(up!.y).toBeGreaterThan(0.9)
})

it('signs that differ, or a single one, do not turn a body', () => {
  const signs = (...all: [number, number, number][]) => all.map((sign) => new Vector3(...sign))
  expect(clearUp(signs([0, 0, 1], [0, 0.1, 1]))).toEqual(new Vector3(0, 0, 1))
  expect(clearUp(signs([0, 0, 1]))).toBeUndefined()
  expect(clearUp(signs([0, 0, 1], [0, 1, 0]))).toBeUndefined()
  expect(clearUp(signs([0, 1, 0], [0, 1, 0.1]))).toBeUndefined()
  expect(clearUp(signs([0, 0.7, 0.7], [0, 0.7, 0.7]))).toBeUndefined()
})
