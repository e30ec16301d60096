import { deflateSync } from 'node:zlib'
import { crc32 } from '../crc32.ts'
import { damageBytes } from './damage-bytes.ts'
import type { Random } from './random.ts'

/** Returns damaged image bytes, other bytes, an oversized image, or an image in an unsupported format. */
export function hostileImage(random: Random, original: Buffer): Buffer {
  const isKtx2 = original[1] === 0x4b
  return random.pick<(random: Random, original: Buffer) => Buffer>([
    ...(isKtx2 ? [damageKtx2, damageKtx2, damageKtx2, damageKtx2] : []),
    damageHeader,
    (r, bytes) => damageBytes(bytes, r),
    (r, bytes) => damageBytes(bytes, r),
    (r) => flatPng(r.pick([1, 3, 63, 4096, 8192, 8193, 16_000, 65_535]), r.pick([1, 2, 64, 8192, 16_000])),
    () => Buffer.from(SVG),
    () => Buffer.from(SVG_BOMB),
    () => Buffer.from(GIF, 'base64'),
    () => Buffer.from('II*\0\x08\0\0\0\xff\xff\0\x01', 'latin1'),
    () => Buffer.from('\0\0\0\x1cftypheic\0\0\0\0mif1heic', 'latin1'),
    () => Buffer.from('%PDF-1.4\n'),
    () => Buffer.from('P6 16000 16000 255\n'),
    () => Buffer.alloc(0),
  ])(random, original)
}

const SVG =
  '<svg xmlns="http://www.w3.org/2000/svg" width="64" height="64"><rect width="9" height="9"/></svg>'
const SVG_BOMB = `<svg xmlns="http://www.w3.org/2000/svg" width="8000" height="8000"><defs><g id="a0"><circle r="900"/></g>${Array.from(
  { length: 7 },
  (_, i) => `<g id="a${i + 1}">${`<use href="#a${i}" x="5"/>`.repeat(10)}</g>`,
).join('')}</defs><use href="#a7"/></svg>`
const GIF = 'R0lGODlhAQABAIAAAAAAAP///yH5BAEAAAAALAAAAAABAAEAAAIBRAA7'

/** Byte offsets of the sizes and offsets in a KTX 2 header (KTX 2.0 specification, section 3.1). */
const KTX2_FIELDS = [12, 16, 20, 24, 28, 32, 36, 40, 44, 48, 52, 56, 60, 64, 72, 80, 88, 96]
const KTX2_NUMBERS = [0, 1, 2, 3, 4, 9, 16, 37, 43, 64, 255, 4096, 8192, 16_384, 65_536, 2 ** 31, 2 ** 32 - 1]

export function damageKtx2(random: Random, original: Buffer): Buffer {
  const bytes = Buffer.from(original)
  for (let changes = 1 + random.int(3); changes > 0; changes--) {
    const at = random.chance(0.8) ? random.pick(KTX2_FIELDS) : 12 + 4 * random.int(60)
    if (at + 4 <= bytes.length) bytes.writeUInt32LE(random.pick(KTX2_NUMBERS), at)
  }
  return bytes
}

/** Returns a copy with changed numbers in the first bytes, where most formats store sizes. */
export function damageHeader(random: Random, original: Buffer): Buffer {
  const bytes = Buffer.from(original)
  for (let changes = 1 + random.int(3); changes > 0; changes--) {
    bytes[random.int(Math.min(64, bytes.length))] = random.pick([0, 1, 127, 128, 255])
  }
  return bytes
}

/** Returns a gray PNG of one colour: few bytes at any size. */
export function flatPng(width: number, height: number): Buffer {
  const header = Buffer.alloc(13)
  header.writeUInt32BE(width, 0)
  header.writeUInt32BE(height, 4)
  header[8] = 8
  const rows = deflateSync(Buffer.alloc(height * (width + 1)), { level: 1 })
  const chunk = (type: string, data: Buffer) => {
    const body = Buffer.concat([Buffer.from(type, 'latin1'), data])
    const ends = Buffer.alloc(8)
    ends.writeUInt32BE(data.length, 0)
    ends.writeUInt32BE(crc32(body), 4)
    return Buffer.concat([ends.subarray(0, 4), body, ends.subarray(4)])
  }
  const signature = Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a])
  return Buffer.concat([
    signature,
    chunk('IHDR', header),
    chunk('IDAT', rows),
    chunk('IEND', Buffer.alloc(0)),
  ])
}
