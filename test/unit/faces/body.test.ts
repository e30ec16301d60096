import { readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { NodeIO } from '@gltf-transform/core'
import { ALL_EXTENSIONS } from '@gltf-transform/extensions'
import type { BoneDriver } from 'furrow'
import { FurrowWrinkleMaps, type MaterialWrinkles } from 'furrow/gltf'
import sharp from 'sharp'
import { describe, expect, it } from 'vitest'

const PATH = fileURLToPath(new URL('../../../faces/body.glb', import.meta.url))
const bytes = readFileSync(PATH)
const document = await new NodeIO()
  .registerExtensions([...ALL_EXTENSIONS, FurrowWrinkleMaps])
  .readBinary(bytes)
const root = document.getRoot()
/** The weight 1 as a normalised 16-bit integer. */
const UNIT_WEIGHT = 65535

const primitiveOf = (name: string) =>
  root
    .listMeshes()
    .find((mesh) => mesh.getName() === name)!
    .listPrimitives()[0]!
const wrinklesOf = (mesh: string) =>
  primitiveOf(mesh).getMaterial()!.getExtension<MaterialWrinkles>('FURROW_wrinkle_maps')
/** Returns area and measured joint of each driver of a mesh. */
const driversOf = (mesh: string) =>
  (wrinklesOf(mesh)!.getDrivers() as BoneDriver[]).map(({ area, joints }) => [area, joints[1]])

describe('the shipped figure', () => {
  it('has under 6 MB', () => {
    expect(bytes.length).toBeLessThan(6e6)
  })

  it('walks, sits, reaches, makes fists, turns and bends', () => {
    expect(root.listAnimations().map((clip) => clip.getName())).toEqual([
      'walk',
      'sit',
      'reach',
      'fist',
      'turn',
      'bend',
    ])
    const joints = new Set(root.listSkins()[0]!.listJoints())
    for (const clip of root.listAnimations())
      for (const channel of clip.listChannels()) expect(joints).toContain(channel.getTargetNode())
  })

  it('has skin weights that add up to exactly 1', () => {
    const skinned = root.listNodes().filter((node) => node.getSkin())
    expect(skinned.map((node) => node.getName())).toEqual(['skin', 'hands', 'shirt', 'trousers', 'shoes'])
    for (const node of skinned) {
      const weights = primitiveOf(node.getName()).getAttribute('WEIGHTS_0')!.getArray()!
      for (let i = 0; i < weights.length; i += 4)
        if (weights[i]! + weights[i + 1]! + weights[i + 2]! + weights[i + 3]! !== UNIT_WEIGHT)
          expect.fail(`vertex ${i / 4} of ${node.getName()}`)
    }
  })

  it.each([
    ['shirt', 'lowerarm01'],
    ['trousers', 'lowerleg01'],
  ])('has folds of the %s on both sides, which only %s drives', (mesh, joint) => {
    expect(driversOf(mesh).slice(0, 2)).toEqual(
      ['L', 'R'].map((side) => [`${joint}.${side} flexion`, `${joint}.${side}`]),
    )
  })

  it('has folds of the shirt in five directions of the trunk, which the spine drives', () => {
    expect(driversOf('trousers')).toHaveLength(2)
    expect(driversOf('shirt').slice(2)).toEqual(
      ['forward', 'tilt to the left', 'tilt to the right', 'turn to the left', 'turn to the right'].map(
        (name) => [`spine01 ${name}`, 'spine01'],
      ),
    )
  })

  it('has creases of both hands and of the neck, and no folds of shoes, eyes and brows', () => {
    expect(wrinklesOf('hands')!.getDrivers().length).toBeGreaterThan(50)
    expect(wrinklesOf('skin')!.getDrivers().length).toBeGreaterThanOrEqual(6)
    const others = root.listMaterials().filter((material) => !material.getExtension('FURROW_wrinkle_maps'))
    expect(others.map((material) => material.getName())).toEqual(
      expect.arrayContaining(['shoes', 'eye', 'brow', 'lash']),
    )
  })

  it.each(['shirt', 'trousers'])('has a %s that rises and never sinks towards the skin', async (mesh) => {
    for (const layer of wrinklesOf(mesh)!.listLayers()) {
      const image = sharp(layer.getTexture('heightTexture')!.getImage()!)
      const { min, max } = (await image.stats()).channels[0]!
      expect(min).toBeGreaterThanOrEqual(127)
      expect(max).toBeGreaterThan(200)
    }
  })

  it.each(['hands', 'shirt', 'trousers'])('has %s whose sides share no texels', (mesh) => {
    const primitive = primitiveOf(mesh)
    const [uv, position] = ['TEXCOORD_0', 'POSITION'].map((name) => primitive.getAttribute(name)!.getArray()!)
    const indices = primitive.getIndices()!.getArray()!
    const size = 512
    const sides = new Int8Array(size * size)
    let shared = 0
    for (let t = 0; t < indices.length; t += 3) {
      const corners = [0, 1, 2].map((k) => indices[t + k]!)
      const x = corners.reduce((sum, i) => sum + position![3 * i]!, 0) / 3
      if (Math.abs(x) < 0.06) continue
      const side = x > 0 ? 1 : 2
      const [u, v] = [0, 1].map((k) => corners.reduce((sum, i) => sum + uv![2 * i + k]!, 0) / 3)
      const texel = Math.floor(v! * size) * size + Math.floor(u! * size)
      if (sides[texel] !== 0 && sides[texel] !== side) shared++
      sides[texel] = side
    }
    expect(shared / (indices.length / 3)).toBeLessThan(0.002)
  })
})
