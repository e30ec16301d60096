import { channelOf } from 'furrow/internal'
import { expect, test } from 'vitest'

test.each([0, 1, 2, 3])(
  'channel %i has the values of all texels, for pixels at any offset in their buffer',
  (channel) => {
    const [width, height] = [5, 3]
    // The buffer has 3 bytes before the pixels and 4 after them.
    const data = Uint8Array.from({ length: 3 + 4 * width * height + 4 }, (_, i) => (37 * i) % 256)
    const pixels = data.subarray(3, 3 + 4 * width * height)
    const expected = Array.from({ length: width * height }, (_, i) => pixels[4 * i + channel])
    const { data: values, ...size } = channelOf({ width, height, data: pixels }, channel)
    expect([...values]).toEqual(expected)
    expect(size).toEqual({ width, height })
  },
)
