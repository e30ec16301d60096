import { AUTO_DEFAULTS, type AutoOptions, autoWrinkles } from 'furrow/author'
import { decodeGlb, documentOf, findSkin } from 'furrow-files'
import { measureStrain } from '../packages/furrow/src/author/auto/strain/measure-strain.ts'
import { prepareSkin } from '../packages/furrow/src/author/auto/surface/prepare-skin.ts'

/** Faces and options. Together they run each step for all regions, on small maps. `small-head.ts` makes the second face. */
export const DIGESTED = {
  'human.glb': { size: 512, age: 70, seed: 1 },
  // Furrows need larger maps. They are drawn only if most of the chosen regions can have them.
  'small-head.glb': {
    size: 1024,
    age: 80,
    seed: 2,
    regions: ['underEye', 'crowsFeet'],
    furrows: true,
    frame: 'derivative',
  },
} as const satisfies Record<string, AutoOptions>

export type DigestedFace = keyof typeof DIGESTED

/** Makes automatic wrinkles for a file with one of the faces. Returns a hash of the result of each step. */
export async function autoDigest(name: DigestedFace, file: Uint8Array): Promise<Record<string, number>> {
  const { skin } = findSkin(await documentOf(decodeGlb(file, name, 'test'), name, 'test'), name, 'test')
  const settings = { ...AUTO_DEFAULTS, ...DIGESTED[name] }
  const prepared = prepareSkin(skin)
  const { surface, offsets, scale } = prepared
  const { regions } = measureStrain(prepared, { ...settings, ageFraction: 0.5, maxAreas: settings.areas })
  const { landmarks, layers, areas, blood, furrows, ...others } = autoWrinkles(skin, DIGESTED[name])
  if (settings.furrows && !furrows) throw new Error(`test: no furrows were drawn, got ${name}`)
  return {
    landmarks: digestOf(landmarks),
    surface: digestOf([surface.points, surface.normals, offsets, scale]),
    strain: digestOf(regions.map(({ tensors }) => tensors)),
    lines: digestOf(layers.map(({ strokes }) => strokes)),
    drivers: digestOf(
      areas.map(({ driver, ageing, compression, error }) => ({ driver, ageing, compression, error })),
    ),
    layers: digestOf(areas.map(({ name, layer, lines }) => ({ name, layer, lines }))),
    maps: digestOf([layers.map(({ strokes: _, ...maps }) => maps), areas.map(({ weights }) => weights)]),
    blood: digestOf(blood),
    furrows: digestOf(furrows),
    others: digestOf(others),
  }
}

/** Returns the FNV-1a hash of all numbers, bit by bit, and all texts in a value. */
function digestOf(value: unknown, hash = 2166136261): number {
  if (typeof value === 'number') return mix(hash, new Float64Array([value]))
  if (ArrayBuffer.isView(value)) return mix(hash, value)
  if (typeof value !== 'object' || value === null) return mix(hash, new TextEncoder().encode(String(value)))
  return Object.entries(value).reduce((sum, [name, part]) => digestOf(part, digestOf(name, sum)), hash)
}

function mix(start: number, { buffer, byteOffset, byteLength }: ArrayBufferView): number {
  let hash = start
  for (const byte of new Uint8Array(buffer, byteOffset, byteLength)) hash = Math.imul(hash ^ byte, 16777619)
  return hash >>> 0
}
