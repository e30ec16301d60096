import { parseWrinkleMaps, WRINKLE_MAPS } from 'furrow'
import { BASIS, usesBasis } from './embed.ts'
import type { Glb, GltfJson } from './glb-file.ts'

type BufferView = NonNullable<GltfJson['bufferViews']>[number]

/**
 * Takes the wrinkles off a material again, with their textures, images and bytes as far as these stand at the end
 * of the file, where `furrow pack` puts them: whatever stands before them keeps its index.
 *
 * @param glb changed in place; its binary part is cut, not copied.
 * @returns number of textures that had to stay, because others follow them.
 */
export function stripWrinkles(glb: Glb, materialIndex: number, who: string): number {
  const { json } = glb
  const material = json.materials![materialIndex]
  const own = ownTextures(json, material.extensions![WRINKLE_MAPS], who)
  material.extensions = without(material.extensions!, WRINKLE_MAPS)
  if (Object.keys(material.extensions).length === 0) delete material.extensions
  if (!json.materials!.some(({ extensions }) => extensions?.[WRINKLE_MAPS])) undeclare(json, WRINKLE_MAPS)

  const others = indicesUnder({ materials: json.materials, extensions: json.extensions }, /tex/i)
  const textures = popWhile(json, 'textures', (index) => own.has(index) && !others.has(index))
  popWhile(
    json,
    'images',
    (index) => textures.some((texture) => imagesOf(texture).has(index)) && !usesImage(json, index),
  )
  if (usesBasis({ textures }) && !usesBasis(json)) undeclare(json, BASIS)
  const views = indicesUnder(json, /^bufferView$/)
  const dropped = popWhile(json, 'bufferViews', (index) => !views.has(index))
  popWhile(
    json,
    'samplers',
    (index) => textures.some((t) => t.sampler === index) && !usesSampler(json, index),
  )
  if (dropped.length > 0) cutBinary(glb, dropped)
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
  ])
  const all = [...infos, ...areas.map(({ texture }) => texture)]
  return new Set(all.flatMap((info) => (info ? [info.index] : [])))
}

/** Images of a texture, those that extensions name among them. */
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

/** Removes items from the end of a list while `goes` says so, and the list itself when it is empty. */
function popWhile<K extends 'textures' | 'images' | 'bufferViews' | 'samplers'>(
  json: GltfJson,
  key: K,
  goes: (index: number) => boolean,
): NonNullable<GltfJson[K]>[number][] {
  const list = (json[key] ?? []) as NonNullable<GltfJson[K]>[number][]
  const gone = []
  while (list.length > 0 && goes(list.length - 1)) gone.push(list.pop()!)
  if (list.length === 0) delete json[key]
  return gone
}

/** Every whole number below a field of that name, however deep: extensions of others are not known here. */
function indicesUnder(value: unknown, name: RegExp, inside = false, found = new Set<number>()): Set<number> {
  if (inside && typeof value === 'number') found.add(value)
  if (typeof value !== 'object' || value === null) return found
  for (const [key, item] of Object.entries(value)) {
    indicesUnder(item, name, inside || (!Array.isArray(value) && name.test(key)), found)
  }
  return found
}

/** Ends the binary part where the dropped views begin, unless others still lie behind. */
function cutBinary(glb: Glb, dropped: readonly BufferView[]): void {
  const { bufferViews = [], buffers = [] } = glb.json
  const kept = bufferViews
    .flatMap((view) => [view, ...compressedViews(view)])
    .filter(({ buffer }) => buffer === 0)
    .map(({ byteOffset = 0, byteLength }) => byteOffset + byteLength)
  const begins = Math.min(...dropped.map(({ byteOffset = 0 }) => byteOffset))
  const end = Math.min(Math.max(begins, ...kept), glb.bin.length)
  glb.bin = glb.bin.subarray(0, end)
  if (buffers[0]) buffers[0].byteLength = end
  if (end === 0 && buffers.length === 1) delete glb.json.buffers
}

/** Compressed meshes name their bytes in an extension of the view. */
function compressedViews({ extensions = {} }: BufferView & { extensions?: object }): BufferView[] {
  return Object.values(extensions).filter((value) => typeof value === 'object' && value?.byteLength > 0)
}

function without(object: Record<string, unknown>, key: string): Record<string, unknown> {
  return Object.fromEntries(Object.entries(object).filter(([name]) => name !== key))
}
