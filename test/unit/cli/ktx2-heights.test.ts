import { encodePng } from 'furrow-files/node'
import { expect, it } from 'vitest'
import { encodeMapArrays } from '../../../packages/files/src/pack/ktx2-images.ts'

it('height maps stay images in files with KTX 2 arrays', async () => {
  const size = { width: 4, height: 4 }
  const bytes = await encodePng({ ...size, channels: 3, data: new Uint8Array(48).fill(128) })
  const image = { name: 'map', mimeType: 'image/png', bytes, ...size }
  const layer = { name: 'a', kind: 'detail' as const, normal: image, height: image, heightAmplitude: 0.001 }
  const [encoded] = await encodeMapArrays([layer], 'test')
  expect(encoded.height).toBe(image)
  expect(encoded.heightAmplitude).toBe(0.001)
  expect(encoded.normal.mimeType).toBe('image/ktx2')
})
