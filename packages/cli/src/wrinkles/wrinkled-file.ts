import { FurrowError, parseWrinkleMaps, WRINKLE_MAPS, type WrinkleMaps } from 'furrow'
import { type Glb, readGlbFile } from './glb-file.ts'

/** A file with the wrinkles of one of its materials. */
export interface WrinkledFile {
  glb: Glb
  /** Index of the material that has them. */
  material: number
  maps: WrinkleMaps
}

/** One material's wrinkles, each checked by itself. */
export function wrinkledMaterials({ json }: Glb): number[] {
  return (json.materials ?? []).flatMap(({ extensions }, index) => {
    return extensions?.[WRINKLE_MAPS] === undefined ? [] : [index]
  })
}

/**
 * Reads a file and the wrinkles of the material of that name, or of the only one that has some.
 *
 * @throws FurrowError when there are none, several and none is named, or they are not valid.
 */
export async function readWrinkledFile(
  path: string,
  who: string,
  materialName?: string,
): Promise<WrinkledFile> {
  const glb = await readGlbFile(path, who)
  const materials = glb.json.materials ?? []
  const all = wrinkledMaterials(glb)
  const found =
    materialName === undefined ? all : all.filter((index) => materials[index].name === materialName)
  if (found.length !== 1) {
    const names = all.map((index) => materials[index].name ?? String(index))
    throw new FurrowError({
      who,
      what:
        all.length === 0
          ? `no wrinkles in ${path}`
          : `${found.length === 0 ? 'no such material' : 'several materials'} with wrinkles in ${path}`,
      value: materialName,
      limit: all.length === 0 ? `a material with ${WRINKLE_MAPS}` : names.join(', '),
      remedy: all.length === 0 ? 'put some in with furrow pack' : 'name one with --material',
    })
  }
  const material = found[0]
  const json = materials[material].extensions![WRINKLE_MAPS]
  return { glb, material, maps: parseWrinkleMaps(json, glb.json.textures?.length ?? 0, `${who}: ${path}`) }
}

/** The maps of a layer by their names in a folder and in the extension. */
export const MAP_SLOTS = [
  ['normal', 'normalTexture'],
  ['baseColor', 'baseColorTexture'],
  ['roughness', 'roughnessTexture'],
  ['occlusion', 'occlusionTexture'],
  ['height', 'heightTexture'],
] as const

/** The encoded image of a texture. */
export interface TextureImage {
  bytes: Uint8Array
  /** As the file says, or as the bytes begin. */
  mimeType: string
  name: string
}

/** Extensions that hold the image of a texture in other formats. */
const IMAGE_EXTENSIONS = ['KHR_texture_basisu', 'EXT_texture_webp', 'EXT_texture_avif']

/** Finds the image of a texture. Throws FurrowError when it is missing, or lies outside the file. */
export function imageOf({ json, bin }: Glb, texture: number, who: string): TextureImage {
  const { source, extensions = {}, name } = json.textures?.[texture] ?? {}
  const other = IMAGE_EXTENSIONS.map((key) => (extensions[key] as { source?: number } | undefined)?.source)
  const image = json.images?.[other.find((index) => index !== undefined) ?? source ?? -1]
  const view = json.bufferViews?.[image?.bufferView ?? -1]
  const from = view?.byteOffset ?? 0
  if (!image || !view || view.buffer !== 0 || from + view.byteLength > bin.length || !(view.byteLength > 0)) {
    throw new FurrowError({
      who,
      what: `texture ${texture} has no image in the file`,
      value: image?.uri,
      remedy: 'export the file as one .glb with its images inside',
    })
  }
  const bytes = bin.subarray(from, from + view.byteLength)
  return {
    bytes,
    mimeType: textOf(image.mimeType) ?? 'unknown',
    name: textOf(image.name) ?? textOf(name) ?? `texture ${texture}`,
  }
}

/** Whether an image is a KTX 2 file. */
export function isKtx2({ mimeType }: TextureImage): boolean {
  return mimeType === 'image/ktx2'
}

/** Where a KTX 2 file says how many layers it has (KTX 2.0, 3.1): after twelve bytes and five words. */
const LAYER_COUNT = 32

/** Layers of a KTX 2 array; 0 for a plain image. */
export function layerCount(image: TextureImage): number {
  if (!isKtx2(image) || image.bytes.length < LAYER_COUNT + 4) return 0
  return Buffer.from(image.bytes).readUInt32LE(LAYER_COUNT)
}

/** Files of others may hold anything where a text belongs. */
function textOf(value: unknown): string | undefined {
  return typeof value === 'string' ? value : undefined
}
