import type { Random } from './random.ts'

/** Truncates a file, or changes, inserts or repeats some of its bytes. */
export function damageBytes(original: Buffer, random: Random): Buffer {
  const bytes = Buffer.from(original)
  if (bytes.length === 0) return Buffer.from([random.int(256)])
  const at = random.int(bytes.length)
  switch (random.pick(['cut', 'flip', 'flip', 'fill', 'insert', 'repeat'])) {
    case 'cut':
      return bytes.subarray(0, at)
    case 'fill':
      return bytes.fill(
        random.pick([0, 255, 0x20]),
        at,
        Math.min(bytes.length, at + random.pick([4, 64, 1024])),
      )
    case 'insert':
      return Buffer.concat([
        bytes.subarray(0, at),
        Buffer.alloc(random.pick([1, 4, 999])),
        bytes.subarray(at),
      ])
    case 'repeat':
      return Buffer.concat([bytes, bytes.subarray(at)])
    default:
      for (let flips = 1 + random.int(16); flips > 0; flips--)
        bytes[random.int(bytes.length)]! ^= 1 << random.int(8)
      return bytes
  }
}
