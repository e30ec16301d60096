import { readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import sharp from 'sharp'
import { expect, it } from 'vitest'
import { pngSize } from '../../../packages/furrow/src/auto/png-size.ts'
import { jsonOf } from '../../glb.ts'

it('the estimated size of maps is that of their PNG files, within a fifth', async () => {
  const bytes = readFileSync(fileURLToPath(new URL('../../../faces/body.glb', import.meta.url)))
  const { images, bufferViews } = jsonOf(bytes)
  const start = bytes.byteLength - bytes.readUInt32LE(20 + bytes.readUInt32LE(12))
  let [files, estimated] = [0, 0]
  for (const { bufferView } of images.filter((image: { name?: string }) => /^auto/.test(image.name ?? ''))) {
    const { byteOffset, byteLength } = bufferViews[bufferView]
    const file = bytes.subarray(start + byteOffset, start + byteOffset + byteLength)
    const { data, info } = await sharp(file).raw().toBuffer({ resolveWithObject: true })
    files += byteLength
    estimated += await pngSize([{ width: info.width * info.channels, data: new Uint8Array(data) }])
  }
  expect(files).toBeGreaterThan(500_000)
  expect(Math.abs(estimated / files - 1)).toBeLessThan(0.2)
})
