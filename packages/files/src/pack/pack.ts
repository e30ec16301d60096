import {
  type AreaConvention,
  areaWeights,
  DEFAULT_AREA_SIZE,
  FurrowError,
  type GrayImage,
  resampleGray,
  type WrinkleSetDocument,
} from 'furrow'
import { sameBytes } from '../base/bytes.ts'
import { didYouMean } from '../base/nearest.ts'
import type { Progress } from '../base/progress.ts'
import { decodeGray } from '../images/decode-gray.ts'
import { withImageErrors } from '../images/image-errors.ts'
import { readStrokes } from '../wrinkles/strokes.ts'
import { type AreasPerImage, encodeAreaImages } from './area-images.ts'
import { withBlood } from './blood-image.ts'
import { type CheckedImage, checkMap, checkOneSize, scaleMap } from './checked-image.ts'
import type { LayerImages, PackedArea, PackedWrinkles } from './embed.ts'
import { AREAS_PER_SLICE, encodeAreaArray, encodeMapArrays } from './ktx2-images.ts'

/** How the images go into the file. */
export interface PackOptions {
  /** Areas in the channels of one PNG image; a slice of a KTX 2 array always holds four. */
  areasPerImage: AreasPerImage
  /** Whether maps and areas become KTX 2 arrays. */
  ktx2: boolean
  /** Side of the areas in texels; by default the document's, or 128. */
  areaSize?: number
  /** Side in texels that the layers' maps are scaled to; by default they keep their size. */
  size?: number
}

export const PACK_DEFAULTS = { areasPerImage: 3, ktx2: false } as const satisfies PackOptions

/** The wrinkles of a folder with their images encoded, and warnings for the user. */
export interface PackedFolder extends PackedWrinkles {
  /** Side of the areas in texels. */
  areaSize: number
  warnings: string[]
}

/** Reads a file by its address in the wrinkle set. */
export type ReadFile = (uri: string) => Promise<Uint8Array>

/**
 * Encodes the images of a wrinkle set for a file, and reads its strokes.
 *
 * @throws FurrowError at the first image or stroke that cannot be used, or layer that does not exist.
 */
export async function packFolder(
  read: ReadFile,
  document: WrinkleSetDocument,
  { areasPerImage, ktx2, areaSize, size }: PackOptions,
  who: string,
  progress: Progress,
): Promise<PackedFolder> {
  const side = areaSize ?? document.areaSize ?? DEFAULT_AREA_SIZE
  const total = document.layers.length + document.areas.length + (ktx2 ? 2 : 0)
  let done = 0
  const step = () => progress(++done, total)
  const warnings: string[] = []
  const names = document.layers.map(({ name }) => name)
  const strokes = document.strokes && readStrokes(await read(document.strokes), document.strokes, names, who)
  const maps = await packLayers(read, document.layers, size, who, step)

  const weights: GrayImage[] = []
  for (const { name, image, convention } of document.areas) {
    weights.push(await readWeights(read, image, convention, side, who))
    if (weights.at(-1)!.data.every((value) => value === 0)) {
      warnings.push(
        `${who}: area "${name}" is visible nowhere; is ${image} in the other convention (--white-is-visible)?`,
      )
    }
    step()
  }
  const layers = ktx2 ? await encodeMapArrays(maps, who) : maps
  if (ktx2) step()
  const images = await (ktx2 ? encodeAreaArray(weights, who) : encodeAreaImages(weights, areasPerImage))
  if (ktx2) step()
  const perImage = ktx2 ? AREAS_PER_SLICE : areasPerImage
  const areas = document.areas.map(
    ({ name, layer, combine, activation }, i): PackedArea => ({
      name,
      image: images[Math.floor(i / perImage)],
      channel: i % perImage,
      layer: layerIndex(document, layer, name, who),
      combine,
      activation,
    }),
  )
  return {
    layers,
    areas,
    drivers: document.drivers ?? [],
    ...(strokes && { strokes }),
    areaSize: side,
    warnings,
  }
}

async function packLayers(
  read: ReadFile,
  layers: WrinkleSetDocument['layers'],
  size: number | undefined,
  who: string,
  step: () => void,
): Promise<(LayerImages & { normal: CheckedImage })[]> {
  // Maps with the same bytes are stored once.
  const loaded: { kind: string; bytes: Uint8Array; image: CheckedImage }[] = []
  const load = async (uri: string | undefined, name: string, kind: 'normals' | 'values' = 'values') => {
    if (uri === undefined) return undefined
    const bytes = await read(uri)
    const known = loaded.find((other) => other.kind === kind && sameBytes(other.bytes, bytes))
    if (known) return known.image
    const image = await withImageErrors(uri, who, async () =>
      scaledTo(size, await checkMap(bytes, name, uri, who), kind, who),
    )
    loaded.push({ kind, bytes, image })
    return image
  }
  const packed: (LayerImages & { normal: CheckedImage })[] = []
  for (const { name, normal, baseColor, roughness, occlusion, height, blood, ...rest } of layers) {
    const images = {
      ...rest,
      name,
      normal: (await load(normal, `${name} normal`, 'normals'))!,
      baseColor: await load(baseColor, `${name} base colour`),
      roughness: await load(roughness, `${name} roughness`),
      occlusion: await load(occlusion, `${name} occlusion`),
      height: await load(height, `${name} height`),
      blood: await load(blood, `${name} blood`),
    }
    packed.push(await withBlood(images, who))
    step()
  }
  checkOneSize(
    packed.map(({ normal }) => normal),
    'normal',
    who,
  )
  return packed
}

async function scaledTo(
  size: number | undefined,
  image: CheckedImage,
  kind: 'normals' | 'values',
  who: string,
) {
  return size === undefined ? image : scaleMap(image, size, kind, who)
}

async function readWeights(
  read: ReadFile,
  uri: string,
  convention: AreaConvention | undefined,
  size: number,
  who: string,
): Promise<GrayImage> {
  const painted = await decodeGray(await read(uri), uri, who)
  return resampleGray(areaWeights(painted, convention, `${who}: ${uri}`), size)
}

function layerIndex({ layers }: WrinkleSetDocument, name: string | undefined, area: string, who: string) {
  const index = name === undefined ? 0 : layers.findIndex((layer) => layer.name === name)
  if (index >= 0) return index
  const names = layers.map((layer) => layer.name)
  throw new FurrowError({
    code: 'unknown-name',
    who,
    what: `area "${area}" is on an unknown layer`,
    value: name,
    limit: names.join(', '),
    remedy: didYouMean(name, names, 'name one of the layers'),
  })
}
