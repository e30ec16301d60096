import { parseWrinkleMaps, WRINKLE_MAPS } from 'furrow/internal'
import type { Glb } from '../gltf/glb.ts'
import { type BufferView, compressedViews, type GltfJson } from '../json/gltf-json.ts'
import { KTX2_EXTENSION, usesKtx2 } from './embed.ts'

/**
 * Removes the wrinkles of a material. Removes textures, images and buffer views only from the end of their lists, where
 * `furrow pack` appended them, so that all other indices stay valid.
 *
 * @param glb changed in place. Its binary chunk becomes a shorter view of the same memory.
 * @returns number of textures that could not be removed, because other textures follow them, or other materials or
 *   extensions use them.
 */
export function stripWrinkles(glb: Glb, materialIndex: number, who: string): number {
  const { json } = glb
  const material = json.materials![materialIndex]
  const own = ownTextures(json, material.extensions![WRINKLE_MAPS], who)
  material.extensions = omit(material.extensions!, WRINKLE_MAPS)
  if (Object.keys(material.extensions).length === 0) delete material.extensions
  if (!json.materials!.some(({ extensions }) => extensions?.[WRINKLE_MAPS])) undeclare(json, WRINKLE_MAPS)

  const others = indicesUnder({ materials: json.materials, extensions: json.extensions }, /tex/i)
  const textures = popWhile(json, 'textures', (index) => own.has(index) && !others.has(index))
  popWhile(
    json,
    'images',
    (index) => textures.some((texture) => imagesOf(texture).has(index)) && !usesImage(json, index),
  )
  if (usesKtx2({ textures }) && !usesKtx2(json)) undeclare(json, KTX2_EXTENSION)
  const views = indicesUnder(json, /^bufferView$/)
  const removed = popWhile(json, 'bufferViews', (index) => !views.has(index))
  popWhile(
    json,
    'samplers',
    (index) => textures.some((t) => t.sampler === index) && !usesSampler(json, index),
  )
  if (removed.length > 0) cutBinaryChunk(glb, removed)
  return own.size - textures.length
}

function ownTextures(json: GltfJson, extension: unknown, who: string): Set<number> {
  const { layers, areas } = parseWrinkleMaps(extension, json.textures?.length ?? 0, who)
  const infos = layers.flatMap((layer) => [
    layer.normalTexture,
    layer.baseColorTexture,
    layer.roughnessTexture,
    layer.occlusionTexture,
    layer.heightTexture,
    layer.bloodTexture,
    layer.onsetTexture,
  ])
  const all = [...infos, ...areas.map(({ texture }) => texture)]
  return new Set(all.flatMap((info) => (info ? [info.index] : [])))
}

/** Returns the indices of the images that a texture and its extensions refer to. */
function imagesOf(texture: object): Set<number> {
  return indicesUnder(texture, /^source$/)
}

function undeclare(json: GltfJson, extension: string): void {
  for (const list of ['extensionsUsed', 'extensionsRequired'] as const) {
    json[list] = json[list]?.filter((name) => name !== extension)
    if (!json[list]?.length) delete json[list]
  }
}

function usesImage({ textures = [], extensions }: GltfJson, index: number): boolean {
  return (
    textures.some((texture) => imagesOf(texture).has(index)) || indicesUnder(extensions, /image/i).has(index)
  )
}

function usesSampler({ textures = [] }: GltfJson, index: number): boolean {
  return textures.some(({ sampler }) => sampler === index)
}

/** Removes items from the end of a list while `isUnused` returns true. Deletes the list if it becomes empty. */
function popWhile<K extends 'textures' | 'images' | 'bufferViews' | 'samplers'>(
  json: GltfJson,
  key: K,
  isUnused: (index: number) => boolean,
): NonNullable<GltfJson[K]>[number][] {
  const list = (json[key] ?? []) as NonNullable<GltfJson[K]>[number][]
  const removed = []
  while (list.length > 0 && isUnused(list.length - 1)) removed.push(list.pop()!)
  if (list.length === 0) delete json[key]
  return removed
}

/**
 * Collects all numbers inside fields whose name matches. Some numbers may not be indices, but no index in such
 * a field of an unknown extension is missed.
 */
function indicesUnder(value: unknown, name: RegExp, inside = false, found = new Set<number>()): Set<number> {
  if (inside && typeof value === 'number') found.add(value)
  if (typeof value !== 'object' || value === null) return found
  for (const [key, item] of Object.entries(value)) {
    indicesUnder(item, name, inside || (!Array.isArray(value) && name.test(key)), found)
  }
  return found
}

/**
 * Truncates the binary chunk where the removed buffer views start, but keeps the bytes of all remaining buffer views.
 */
function cutBinaryChunk(glb: Glb, removed: readonly BufferView[]): void {
  const { bufferViews = [], buffers = [] } = glb.json
  const kept = bufferViews
    .flatMap((view) => [view, ...compressedViews(view)])
    .filter(({ buffer }) => buffer === 0)
    .map(({ byteOffset = 0, byteLength }) => byteOffset + byteLength)
  const start = Math.min(...removed.map(({ byteOffset = 0 }) => byteOffset))
  const end = Math.min(Math.max(start, ...kept), glb.bin.length)
  glb.bin = glb.bin.subarray(0, end)
  if (buffers[0]) buffers[0].byteLength = end
  if (end === 0 && buffers.length === 1) delete glb.json.buffers
}

function omit(object: Record<string, unknown>, key: string): Record<string, unknown> {
  return Object.fromEntries(Object.entries(object).filter(([name]) => name !== key))
}
