import { FurrowError, type GrayImage } from 'furrow'
import { DEFAULT_AREA_SIZE, didYouMean, resampleGray } from 'furrow/internal'
import { sameBytes } from '../base/bytes.ts'
import type { Progress } from '../base/progress.ts'
import { withImageErrors } from '../images/image-errors.ts'
import { encodePortablePng } from '../images/png.ts'
import { type AreasPerImage, encodeAreaImages } from './area-images.ts'
import { type CheckedImage, checkMap, checkOneSize, scaleMap } from './checked-image.ts'
import type { LayerImages, PackedArea, PackedWrinkles } from './embed.ts'
import { AREAS_PER_SLICE, encodeAreaArray, encodeMapArrays } from './ktx2-images.ts'
import type { MapToPack, SetToPack } from './set-to-pack.ts'
import { shareImage } from './share-image.ts'

/** Options for the size and encoding of images in the packed file. */
export interface PackOptions {
  /** Number of areas in one PNG image, one per channel. Ignored with `ktx2`, where a slice holds four areas. */
  areasPerImage: AreasPerImage
  /** Whether maps and areas become KTX 2 arrays. */
  ktx2: boolean
  /** Width and height of the areas, texels. Default: `areaSize` of the wrinkle set, or 128. */
  areaSize?: number
  /** Width and height of the maps, texels. Default: maps keep their size. */
  size?: number
}

export const PACK_DEFAULTS = { areasPerImage: 3, ktx2: false } as const satisfies PackOptions

/** A wrinkle set with its images encoded. */
export interface PackedSet extends PackedWrinkles {
  /** Width and height of the areas, texels. */
  areaSize: number
  warnings: string[]
}

/**
 * Loads, checks, scales and encodes the images of a wrinkle set.
 *
 * @throws FurrowError for the first invalid image or stroke, or if an area names a layer that does not exist.
 */
export async function packSet(
  set: SetToPack,
  { areasPerImage, ktx2, areaSize, size }: PackOptions,
  who: string,
  progress: Progress,
): Promise<PackedSet> {
  const side = areaSize ?? set.areaSize ?? DEFAULT_AREA_SIZE
  const total = set.layers.length + set.areas.length + (ktx2 ? 2 : 0)
  let done = 0
  const step = () => progress(++done, total)
  const warnings: string[] = []
  const strokes = await set.strokes?.()
  const maps = await packLayers(set.layers, size, who, step)

  const weights: GrayImage[] = []
  for (const area of set.areas) {
    const resampled = resampleGray(await area.weights(), side)
    if (!area.isHidden && resampled.data.every((value) => value === 0)) {
      warnings.push(`${who}: area "${area.name}" is empty${area.hint ?? ''}`)
    }
    weights.push(resampled)
    step()
  }
  const layers = ktx2 ? await encodeMapArrays(maps, who) : maps
  if (ktx2) step()
  const images = await (ktx2 ? encodeAreaArray(weights, who) : encodeAreaImages(weights, areasPerImage))
  if (ktx2) step()
  const perImage = ktx2 ? AREAS_PER_SLICE : areasPerImage
  const areas = set.areas.map(
    ({ name, layer, combine, activation }, i): PackedArea => ({
      name,
      image: images[Math.floor(i / perImage)],
      channel: i % perImage,
      layer: layerIndex(set, layer, name, who),
      combine,
      activation,
    }),
  )
  return {
    layers,
    areas,
    drivers: set.drivers ?? [],
    ...(strokes && { strokes }),
    shapes: set.shapes,
    areaSize: side,
    warnings,
  }
}

async function packLayers(
  layers: SetToPack['layers'],
  size: number | undefined,
  who: string,
  step: () => void,
): Promise<(LayerImages & { normal: CheckedImage })[]> {
  // Maps with the same bytes share one image.
  const loaded: { kind: string; bytes: Uint8Array; image: CheckedImage }[] = []
  const load = async (map: MapToPack | undefined, name: string, kind: 'normals' | 'values' = 'values') => {
    if (!map) return undefined
    const { path, bytes } = 'bytes' in map ? map : { path: name, bytes: encodePortablePng(map) }
    const known = loaded.find((other) => other.kind === kind && sameBytes(other.bytes, bytes))
    if (known) return known.image
    const image = await withImageErrors(path, who, async () => {
      const checked =
        'bytes' in map
          ? await checkMap(bytes, name, path, who)
          : { name, mimeType: 'image/png', bytes, width: map.width, height: map.height }
      return scaledTo(size, checked, kind, who)
    })
    loaded.push({ kind, bytes, image })
    return image
  }
  const packed: (LayerImages & { normal: CheckedImage })[] = []
  for (const { maps, ...layer } of layers) {
    const { name } = layer
    const images = {
      ...layer,
      normal: (await load(await maps.normal(), `${name} normal`, 'normals'))!,
      baseColor: await load(await maps.baseColor?.(), `${name} base colour`),
      roughness: await load(await maps.roughness?.(), `${name} roughness`),
      occlusion: await load(await maps.occlusion?.(), `${name} occlusion`),
      height: await load(await maps.height?.(), `${name} height`),
      blood: await load(await maps.blood?.(), `${name} blood`),
      onset: await load(await maps.onset?.(), `${name} onset`),
    }
    packed.push(await shareImage(images, who))
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

function layerIndex({ layers }: SetToPack, name: string | undefined, area: string, who: string) {
  const index = name === undefined ? 0 : layers.findIndex((layer) => layer.name === name)
  if (index >= 0) return index
  const names = layers.map((layer) => layer.name)
  throw new FurrowError({
    code: 'unknown-name',
    who,
    problem: `area "${area}" is on an unknown layer`,
    value: name,
    limit: names.join(', '),
    remedy: didYouMean(name, names, 'name one of the layers'),
  })
}
