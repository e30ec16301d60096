import type { ErrorParts } from '../error.ts'
import { MAX_IMAGE_SIDE } from '../limits.ts'
import { WRINKLE_MAPS } from './declared.ts'
import type { MapsAndAreas, TextureReference, WrinkleMapsLayer } from './wrinkle-maps.ts'

/** Size and format of a texture's image. */
export interface TextureShape {
  width: number
  height: number
  /** KTX 2 only: slices of an array, 0 for a plain image. Undefined for other formats. */
  slices?: number
  /** KTX 2 only: encoding and mipmap levels. Must be equal for all textures of one array. */
  layout?: string
}

/** A broken rule for the maps of a file. */
export interface MapProblem extends ErrorParts {
  rule: 'IMAGE_SIZE' | 'LAYER_SIZES' | 'MIXED_FORMATS' | 'KTX2_LAYOUTS' | 'NO_SLICE' | 'ARRAY_AS_IMAGE'
}

/** Kinds of drawn maps, with their slots and their names in errors. Heights are not drawn. */
const KINDS = {
  normal: { normalTexture: 'normal' },
  'base colour': { baseColorTexture: 'base colour' },
  roughness: { roughnessTexture: 'roughness' },
  occlusion: { occlusionTexture: 'occlusion', bloodTexture: 'blood' },
} as const satisfies Record<string, Partial<Record<keyof WrinkleMapsLayer, string>>>

type MapSlot = Extract<keyof WrinkleMapsLayer, `${string}Texture`>

/** Texture of a map or an area, and its label in errors. */
type LabelledTexture = TextureReference & { label: string }

/** Lists the textures of drawn maps and areas, each once. */
export function drawnTextures(maps: MapsAndAreas): number[] {
  return [...new Set(kindsOf(maps).flatMap(([, infos]) => infos.map(({ index }) => index)))]
}

/**
 * Checks the images of a file's maps: the rules that need more than the JSON. Shared by loaders and `furrow validate`.
 *
 * @param shapeOf returns the shape of each texture in `drawnTextures`.
 * @param faceTextures textures that other parts of the file use, see `texturesOfFace`.
 * @param who name of the file or material in errors.
 * @returns all broken rules; loaders report the first.
 */
export function mapProblems(
  maps: MapsAndAreas,
  shapeOf: (texture: number) => TextureShape,
  faceTextures: ReadonlySet<number>,
  who: string,
): MapProblem[] {
  const kinds = kindsOf(maps)
  const infos = kinds.flatMap(([, ofKind]) => ofKind)
  const withoutSlice = infos.flatMap(({ index, slice }) => (slice === undefined ? index : []))
  const images = new Set([...faceTextures, ...withoutSlice])
  return [
    ...drawnTextures(maps).flatMap((index) => textureProblems(index, shapeOf(index), images, who)),
    ...infos.flatMap((info) => sliceProblem(info, shapeOf(info.index), who) ?? []),
    ...kinds.flatMap(([kind, ofKind]) => kindProblem(kind, ofKind, shapeOf, who) ?? []),
  ]
}

/** Lists the maps of each kind, then the areas. */
function kindsOf({ layers, areas }: MapsAndAreas): [kind: string, infos: LabelledTexture[]][] {
  const maps = Object.entries(KINDS).map(([kind, slots]): [string, LabelledTexture[]] => [
    `${kind} maps`,
    layers.flatMap((layer) =>
      Object.entries(slots).flatMap(([slot, map]) => {
        const info = layer[slot as MapSlot]
        return info ? [{ ...info, label: `layer "${layer.name}": ${map}` }] : []
      }),
    ),
  ])
  return [...maps, ['areas', areas.map(({ name, texture }) => ({ ...texture, label: `area "${name}"` }))]]
}

/** @param images textures used without a slice: KHR_texture_basisu allows only plain images there. */
function textureProblems(
  index: number,
  { width, height, slices }: TextureShape,
  images: ReadonlySet<number>,
  who: string,
): MapProblem[] {
  const problems: MapProblem[] = []
  if (Math.max(width, height) > MAX_IMAGE_SIDE) {
    problems.push({
      rule: 'IMAGE_SIZE',
      code: 'out-of-range',
      who,
      problem: `image of texture ${index} too large`,
      value: `${width} x ${height}`,
      limit: `at most ${MAX_IMAGE_SIDE} texels per side`,
      remedy: 'scale the image down',
    })
  }
  if (slices && images.has(index)) {
    problems.push({
      rule: 'ARRAY_AS_IMAGE',
      who,
      problem: `texture ${index} is an array of ${slices} slices, but is used without a slice index`,
      remedy: 'add `slice` to the texture info, or use a separate image for the plain face',
    })
  }
  return problems
}

function sliceProblem(
  { slice, label }: LabelledTexture,
  { slices }: TextureShape,
  who: string,
): MapProblem | undefined {
  if (slice === undefined) return undefined
  // A plain KTX 2 image is read as an array of one slice.
  const count = slices === undefined ? 0 : Math.max(slices, 1)
  if (slice < count) return undefined
  return {
    rule: 'NO_SLICE',
    code: 'out-of-range',
    who,
    problem: `${label}: no such slice`,
    value: slice,
    limit: count === 0 ? 'no slice, because the image is not KTX 2' : `0 to ${count - 1}`,
    remedy: 'pack the file again',
  }
}

/** Maps of one kind become one array: images are packed, KTX 2 textures are joined without decoding. */
function kindProblem(
  kind: string,
  infos: readonly LabelledTexture[],
  shapeOf: (texture: number) => TextureShape,
  who: string,
): MapProblem | undefined {
  const shapes = infos.map(({ index }) => shapeOf(index))
  const sizes = [...new Set(shapes.map(({ width, height }) => `${width} x ${height}`))]
  const compressed = shapes.filter(({ slices }) => slices !== undefined)
  if (compressed.length > 0 && compressed.length < shapes.length) {
    const remedy = 'pack all of them with or without KTX 2'
    return { rule: 'MIXED_FORMATS', who, problem: `some ${kind} are KTX 2 and others are not`, remedy }
  }
  // Uncompressed areas are resampled to one size.
  const mayDiffer = kind === 'areas' && compressed.length === 0
  if (sizes.length > 1 && !mayDiffer) {
    const limit = 'one size for all layers'
    return {
      rule: 'LAYER_SIZES',
      who,
      problem: `${kind} differ in size`,
      value: sizes.join(', '),
      limit,
      remedy: 'scale the images to one size',
    }
  }
  const layouts = [...new Set(compressed.map(({ layout }) => layout))]
  if (layouts.length < 2) return undefined
  return {
    rule: 'KTX2_LAYOUTS',
    who,
    problem: `${kind} are encoded differently`,
    value: layouts.join(', '),
    limit: 'one encoding and number of mipmap levels',
    remedy: 'encode them with `furrow pack --ktx2`',
  }
}

/** Returns the indices of textures used by the file outside the extension. */
export function texturesOfFace(json: { materials?: unknown; extensions?: unknown }): Set<number> {
  return collectTextures([json.materials, json.extensions], '', new Set())
}

function collectTextures(json: unknown, key: string, found: Set<number>): Set<number> {
  if (typeof json !== 'object' || json === null || key === WRINKLE_MAPS) return found
  const { index } = json as { index?: unknown }
  if (/texture$/i.test(key) && typeof index === 'number') found.add(index)
  for (const [name, item] of Object.entries(json)) collectTextures(item, name, found)
  return found
}
