import { fileURLToPath } from 'node:url'
import { NodeIO } from '@gltf-transform/core'
import { ALL_EXTENSIONS } from '@gltf-transform/extensions'
import { FurrowWrinkleMaps } from 'furrow/gltf'
import { generateTangents } from 'mikktspace'
import { describe, expect, it } from 'vitest'
import { Workshop } from '../cli/workshop.ts'

const shop = new Workshop()

describe.each(['human.glb', 'human-2.glb', 'hand.glb', 'neck.glb', 'body.glb'])('the shipped %s', (file) => {
  const path = fileURLToPath(new URL(`../../../faces/${file}`, import.meta.url))

  it('is valid without warnings', async () => {
    await shop.run('validate', path)
    expect(shop.printed).toBe(`${path}: 0 errors, 0 warnings\n`)
  })

  it('has MikkTSpace tangents on the skin', async () => {
    const io = new NodeIO().registerExtensions([...ALL_EXTENSIONS, FurrowWrinkleMaps])
    const document = await io.read(path)
    const skin = document
      .getRoot()
      .listMeshes()
      .find((mesh) => mesh.getName() === 'skin')!
    const [primitive] = skin.listPrimitives()
    const indices = [...primitive.getIndices()!.getArray()]
    const corners = (attribute: string, size: number) => {
      const values = primitive.getAttribute(attribute)!.getArray()
      return Float32Array.from(indices.flatMap((i) => [...values.subarray(i * size, i * size + size)]))
    }
    // Signs are opposite, because v points up in MikkTSpace and down in glTF.
    const exact = generateTangents(corners('POSITION', 3), corners('NORMAL', 3), corners('TEXCOORD_0', 2))
    const stored = corners('TANGENT', 4)
    let close = 0
    for (let i = 0; i < indices.length; i++) {
      const cosine = [0, 1, 2].reduce((sum, k) => sum + stored[4 * i + k] * exact[4 * i + k], 0)
      if (cosine > Math.cos(Math.PI / 180) && stored[4 * i + 3] === -exact[4 * i + 3]) close++
    }
    expect(close / indices.length).toBeGreaterThan(0.999)
  })
})
