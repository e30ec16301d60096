import { materialReader } from 'furrow/internal/three'
import { expect, test, vi } from 'vitest'

const decoded = vi.hoisted(() => ({ count: 0 }))

// Fake images. The first byte of each, times 1024, is its width and height.
vi.mock('../../../packages/furrow/src/runtime/file/decode-image.ts', () => ({
  decodeBytes: async ([side]: Uint8Array) => {
    decoded.count++
    return { width: 1024 * side!, height: 1024 * side!, data: new Uint8Array() }
  },
}))

/** Returns a fake parser of a file. Each face is a list with the size of each layer's normal map, divided by 1024. */
function parserOf(...faces: number[][]) {
  const sides = faces.flat()
  let next = 0
  const materials = faces.map((layers) => ({
    extensions: {
      FURROW_wrinkle_maps: {
        layers: layers.map((_, i) => ({ name: `l${i}`, normalTexture: { index: next++ } })),
        areas: [{ name: 'a', layer: 0, texture: { index: sides.length }, channel: 0 }],
      },
    },
  }))
  const images = [...sides, 0].map((side) => ({ bufferView: side }))
  return {
    json: {
      extensionsUsed: ['FURROW_wrinkle_maps'],
      materials,
      images,
      textures: images.map((_, source) => ({ source })),
    },
    options: {},
    getDependency: async (_: string, side: number) => Uint8Array.of(side).buffer,
  }
}

const read = (...faces: number[][]) => {
  decoded.count = 0
  const ofMaterial = materialReader(parserOf(...faces) as never)
  return Promise.allSettled(faces.map((_, material) => ofMaterial(material)))
}

test('images of 512 MiB in total are loaded', async () => {
  const [face] = await read([8, 8])
  expect(face).toMatchObject({ status: 'fulfilled' })
})

test('larger ones are refused, and later ones are not decoded', async () => {
  const [face] = await read([8, 8, 8, 8])
  expect(face).toMatchObject({
    status: 'rejected',
    reason: {
      message: expect.stringMatching(/total size of the wrinkle images too large, got "768 MiB decoded"/),
    },
  })
  await Promise.resolve()
  expect(decoded.count).toBeLessThanOrEqual(3)
})

test('the images of all faces of a file count together', async () => {
  const faces = await read([8], [8], [4])
  expect(faces.map(({ status }) => status)).toContain('rejected')
})
