import { type AutoWrinkles, autoWrinkles } from 'furrow/author'
import { decodeGlb, documentOf, findSkin } from 'furrow-files'

/** Small, but runs every step. */
const OPTIONS = { size: 512, age: 70 }

/** Hashes each part of a face's automatic wrinkles. Equal hashes mean equal bits. */
export async function autoDigest(file: Uint8Array): Promise<Record<string, number>> {
  const found = findSkin(
    await documentOf(decodeGlb(file, 'human.glb', 'test'), 'human.glb', 'test'),
    'human.glb',
    'test',
  )
  const wrinkles: AutoWrinkles = autoWrinkles(found.skin, OPTIONS)
  return Object.fromEntries(Object.entries(wrinkles).map(([name, part]) => [name, digestOf(part)]))
}

/** FNV-1a hash of all numbers, to the last bit, and all texts. */
function digestOf(value: unknown, hash = 2166136261): number {
  if (typeof value === 'number') return mix(hash, ...new Uint32Array(new Float64Array([value]).buffer))
  if (typeof value === 'string') return mix(hash, ...Array.from(value, (letter) => letter.codePointAt(0)!))
  if (ArrayBuffer.isView(value))
    return (value as Float64Array).reduce<number>((sum, x) => digestOf(x, sum), hash)
  if (typeof value !== 'object' || value === null) return digestOf(String(value), hash)
  return Object.entries(value).reduce((sum, [name, part]) => digestOf(part, digestOf(name, sum)), hash)
}

function mix(hash: number, ...words: number[]): number {
  return words.reduce((sum, word) => Math.imul(sum ^ word, 16777619) >>> 0, hash)
}
