import { DecodedBytes } from 'furrow/internal'
import { expect, test } from 'vitest'

const large = { width: 8192, height: 8192 }

test('images may take 512 MiB in total, at four bytes per texel', () => {
  const decoded = new DecodedBytes()
  decoded.add(0, large, 'face')
  decoded.add(1, { width: 1024, height: 1024, slices: 64 }, 'face')
  expect(() => decoded.add(2, { width: 4, height: 4, slices: 0 }, 'face')).toThrow(
    'face: total size of the wrinkle images too large, got "513 MiB decoded", allowed: 512 MiB per file; scale the images down',
  )
  expect(() => decoded.check('face')).toThrow('total size')
})

test('an image shared by several maps counts once', () => {
  const decoded = new DecodedBytes()
  for (let i = 0; i < 10; i++) decoded.add(7, large, 'face')
})
