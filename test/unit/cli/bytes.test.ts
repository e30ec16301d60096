import { posix } from 'node:path'
import fc from 'fast-check'
import { fromUtf8, normalised } from 'furrow-files'
import { expect, it } from 'vitest'
import {
  concat,
  fromBase64,
  fromLatin1,
  latin1,
  sameBytes,
  utf8,
} from '../../../packages/files/src/base/bytes.ts'

const bytes = fc.uint8Array({ maxLength: 40 })

it('bytes and texts are converted like Node converts them', () => {
  fc.assert(
    fc.property(bytes, fc.string({ unit: 'grapheme' }), (data, text) => {
      expect(latin1(data)).toBe(Buffer.from(data).toString('latin1'))
      expect(fromUtf8(data)).toBe(Buffer.from(data).toString())
      expect([...fromLatin1(text)]).toEqual([...Buffer.from(text, 'latin1')])
      expect([...utf8(text)]).toEqual([...Buffer.from(text)])
    }),
  )
})

it('base64 is read in both alphabets, with or without padding, with line breaks, and truncated', () => {
  fc.assert(
    fc.property(bytes, fc.nat(60), (data, end) => {
      for (const encoding of ['base64', 'base64url'] as const) {
        const text = Buffer.from(data).toString(encoding)
        expect([...fromBase64(text)]).toEqual([...data])
        expect([...fromBase64(text.replace(/(.{4})/g, '$1\r\n'))]).toEqual([...data])
        expect([...fromBase64(text.slice(0, end))]).toEqual([...Buffer.from(text.slice(0, end), encoding)])
      }
    }),
  )
})

it('bytes are joined and compared', () => {
  fc.assert(
    fc.property(fc.array(bytes, { maxLength: 4 }), (parts) => {
      const joined = concat(parts)
      expect([...joined]).toEqual([...Buffer.concat(parts)])
      expect(sameBytes(joined, Uint8Array.from(joined))).toBe(true)
      expect(sameBytes(joined, concat([joined, Uint8Array.of(0)]))).toBe(false)
      if (joined.length > 0)
        expect(
          sameBytes(
            joined,
            joined.map((byte) => byte ^ 1),
          ),
        ).toBe(false)
    }),
  )
})

it('relative paths are normalised as the Khronos validator does', () => {
  const part = fc.constantFrom('a', 'b c', '..', '.', '', '..x')
  fc.assert(
    fc.property(fc.array(part, { minLength: 1, maxLength: 6 }), (parts) => {
      const path = parts.join('/').replace(/^\/+|\/+$/g, '')
      expect(normalised(path)).toBe(posix.normalize(path).replace(/^\.$|\/$/, ''))
    }),
  )
})
