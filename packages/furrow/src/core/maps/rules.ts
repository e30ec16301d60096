import type { ErrorParts } from '../error.ts'
import { MAX_IMAGE_SIDE } from '../limits.ts'
import { WRINKLE_MAPS } from './declared.ts'
import type { MapsAndAreas, TextureReference, WrinkleMapsLayer } from './wrinkle-maps.ts'

export interface TextureShape {
  width: number
  height: number
  /** Number of slices of a KTX 2 array; 0 for a single KTX 2 image. Undefined for other formats. */
  slices?: number
  /** Encoding and number of mipmap levels of a KTX 2 image, as text. Maps of one kind must have the same layout. */
  layout?: string
}

/** A problem with the wrinkle maps of a glTF file. */
export interface MapProblem extends ErrorParts {
  rule: 'IMAGE_SIZE' | 'LAYER_SIZES' | 'MIXED_FORMATS' | 'KTX2_LAYOUTS' | 'NO_SLICE' | 'ARRAY_AS_IMAGE'
}

/**
 * Maps that materials sample, grouped by kind. Keys are texture properties of a layer, and values are names for error messages.
 * Height maps are left out, because materials do not sample them.
 */
const KINDS = {
  normal: { normalTexture: 'normal' },
  'base colour': { baseColorTexture: 'base colour' },
  roughness: { roughnessTexture: 'roughness' },
  occlusion: { occlusionTexture: 'occlusion', bloodTexture: 'blood', onsetTexture: 'onset' },
} as const satisfies Record<string, Partial<Record<keyof WrinkleMapsLayer, string>>>

type MapSlot = Extract<keyof WrinkleMapsLayer, `${string}Texture`>

type LabelledTexture = TextureReference & { label: string }

/** Lists the indices of all textures that store areas or maps of the kinds in `KINDS`. Each index is listed once. */
export function drawnTextures(maps: MapsAndAreas): number[] {
  return [...new Set(kindsOf(maps).flatMap(([, infos]) => infos.map(({ index }) => index)))]
}

/**
 * Checks the wrinkle maps of a file by the rules that need the headers of the images. `readMaps` checks the rules that need only the JSON.
 * Loaders and `furrow validate` share these rules.
 *
 * @param shapeOf returns the size and format of a texture that `drawnTextures` lists.
 * @param faceTextures textures that the file uses outside the extension; see `texturesOfFace`.
 * @param who name of the file or material in errors.
 * @returns all problems. Several textures can break the same rule. Loaders report only the first problem.
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

/** @param images textures that the file uses without a slice index. KHR_texture_basisu does not allow arrays there. */
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
      remedy: 'add `slice` to the texture info, or use another image there',
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
  // A single KTX 2 image counts as an array of one slice.
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

/** Checks that maps of one kind can share a texture array. KTX 2 textures are joined into the array without decoding. */
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
  // Areas that are not KTX 2 may differ in size, because they are resampled to one size.
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

/** Returns the indices of all textures that the file uses outside the extension. */
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
