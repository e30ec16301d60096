import type { ErrorParts } from '../error.ts'
import { MAX_IMAGE_SIDE } from '../limits.ts'
import { WRINKLE_MAPS } from './declared.ts'
import type { MapsAndAreas, TextureReference, WrinkleMapsLayer } from './wrinkle-maps.ts'

/** What reading the image of a texture tells about it. */
export interface TextureShape {
  width: number
  height: number
  /** Of a KTX 2 file: slices of an array, 0 where it is a plain image; undefined for images of other formats. */
  slices?: number
  /** Of a KTX 2 file: its encoding and levels, which are the same in all that become one array. */
  layout?: string
}

/** A rule that the maps of a file break. */
export interface MapProblem extends ErrorParts {
  rule: 'IMAGE_SIZE' | 'LAYER_SIZES' | 'MIXED_FORMATS' | 'KTX2_LAYOUTS' | 'NO_SLICE' | 'ARRAY_AS_IMAGE'
}

/** The kinds of maps that are drawn, with their slots and names for errors. Heights are for tools. */
const KINDS = {
  normal: { normalTexture: 'normal' },
  'base colour': { baseColorTexture: 'base colour' },
  roughness: { roughnessTexture: 'roughness' },
  occlusion: { occlusionTexture: 'occlusion', bloodTexture: 'blood' },
} as const satisfies Record<string, Partial<Record<keyof WrinkleMapsLayer, string>>>

type MapSlot = Extract<keyof WrinkleMapsLayer, `${string}Texture`>

/** A map or an area: its texture, and what to call it in errors. */
type Named = TextureReference & { called: string }

/** The textures of the maps and areas that are drawn, each once. */
export function drawnTextures(maps: MapsAndAreas): number[] {
  return [...new Set(kindsOf(maps).flatMap(([, infos]) => infos.map(({ index }) => index)))]
}

/**
 * Checks the maps of a file by what their images are: the rules that the JSON alone cannot tell. Loaders and `furrow validate` use the
 * same ones.
 *
 * @param shapeOf of each texture in `drawnTextures`.
 * @param ofFace textures that something else in the file uses, see `texturesOfFace`.
 * @param who names the file or material in errors.
 * @returns the rules that are broken; a loader reports the first.
 */
export function mapProblems(
  maps: MapsAndAreas,
  shapeOf: (texture: number) => TextureShape,
  ofFace: ReadonlySet<number>,
  who: string,
): MapProblem[] {
  const kinds = kindsOf(maps)
  const infos = kinds.flatMap(([, ofKind]) => ofKind)
  const withoutSlice = infos.flatMap(({ index, slice }) => (slice === undefined ? index : []))
  const images = new Set([...ofFace, ...withoutSlice])
  return [
    ...drawnTextures(maps).flatMap((index) => textureProblems(index, shapeOf(index), images, who)),
    ...infos.flatMap((info) => sliceProblem(info, shapeOf(info.index), who) ?? []),
    ...kinds.flatMap(([kind, ofKind]) => kindProblem(kind, ofKind, shapeOf, who) ?? []),
  ]
}

/** The maps of each kind, and the areas. */
function kindsOf({ layers, areas }: MapsAndAreas): [kind: string, infos: Named[]][] {
  const maps = Object.entries(KINDS).map(([kind, slots]): [string, Named[]] => [
    `${kind} maps`,
    layers.flatMap((layer) =>
      Object.entries(slots).flatMap(([slot, map]) => {
        const info = layer[slot as MapSlot]
        return info ? [{ ...info, called: `layer "${layer.name}": ${map}` }] : []
      }),
    ),
  ])
  return [...maps, ['areas', areas.map(({ name, texture }) => ({ ...texture, called: `area "${name}"` }))]]
}

/** @param images textures that texture infos without a slice refer to: KHR_texture_basisu allows them plain images only. */
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
      problem: `the image of texture ${index} is too large`,
      value: `${width} x ${height}`,
      limit: `${MAX_IMAGE_SIDE} texels on a side`,
      remedy: 'scale it down',
    })
  }
  if (slices && images.has(index)) {
    problems.push({
      rule: 'ARRAY_AS_IMAGE',
      who,
      problem: `texture ${index} is an array of ${slices}, and a texture info without a slice refers to it`,
      remedy: 'name a slice, or give the plain face an image of its own',
    })
  }
  return problems
}

function sliceProblem(
  { slice, called }: Named,
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
    problem: `${called}: no such slice`,
    value: slice,
    limit: count === 0 ? 'no slice: the image is not KTX 2' : `0 to ${count - 1}`,
    remedy: 'pack the file again',
  }
}

/** Maps of a kind become one array: images are packed, and compressed ones joined as they are. */
function kindProblem(
  kind: string,
  infos: readonly Named[],
  shapeOf: (texture: number) => TextureShape,
  who: string,
): MapProblem | undefined {
  const shapes = infos.map(({ index }) => shapeOf(index))
  const texts = [...new Set(shapes.map(({ width, height }) => `${width} x ${height}`))]
  const compressed = shapes.filter(({ slices }) => slices !== undefined)
  if (compressed.length > 0 && compressed.length < shapes.length) {
    const remedy = 'pack them in the same way'
    return { rule: 'MIXED_FORMATS', who, problem: `some ${kind} are KTX 2, and others are not`, remedy }
  }
  // Areas in images are resampled to one size.
  const mayDiffer = kind === 'areas' && compressed.length === 0
  if (texts.length > 1 && !mayDiffer) {
    const limit = 'one size for all layers'
    return {
      rule: 'LAYER_SIZES',
      who,
      problem: `${kind} differ in size`,
      value: texts.join(', '),
      limit,
      remedy: 'scale them to one size',
    }
  }
  const layouts = [...new Set(compressed.map(({ layout }) => layout))]
  if (layouts.length < 2) return undefined
  return {
    rule: 'KTX2_LAYOUTS',
    who,
    problem: `${kind} are encoded differently`,
    value: layouts.join(', '),
    limit: 'one encoding and number of levels',
    remedy: 'let `furrow pack --ktx2` encode them',
  }
}

/** Indices of the textures that anything in a file but the extension uses. */
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
