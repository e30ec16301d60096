import { draco, meshopt, quantize } from '@gltf-transform/functions'
import { findSkin } from 'furrow-files'
import { MeshoptEncoder } from 'meshoptimizer/encoder'
import { expect, test } from 'vitest'
import { faceSeed } from '../../../../packages/furrow/src/author/auto/anatomy/face-seed.ts'
import { detectFace } from '../../../../packages/furrow/src/author/auto/surface/detect-face.ts'
import { anyIO, HUMAN, plainFace } from '../../cli/auto-variants.ts'

const FACES = [HUMAN, HUMAN.replace('human.glb', 'human-2.glb')]

test.each(FACES)('the default seed of %s is the same in compressed files', async (path) => {
  const plain = await seedOf(path)
  const compressed = [
    await seedOf(path, quantize()),
    await seedOf(path, draco()),
    await seedOf(path, meshopt({ encoder: MeshoptEncoder, level: 'medium' })),
  ]
  expect(compressed).toEqual([plain, plain, plain])
})

test('different faces have different seeds', async () => {
  expect(await seedOf(FACES[0])).not.toBe(await seedOf(FACES[1]))
})

async function seedOf(path: string, ...changes: ReturnType<typeof quantize>[]): Promise<number> {
  const [io, document] = [await anyIO(), await plainFace(path)]
  await document.transform(...changes)
  const read = await io.readBinary(await io.writeBinary(document))
  return faceSeed(detectFace(findSkin(read, path, 'test').skin)!.landmarks)
}
