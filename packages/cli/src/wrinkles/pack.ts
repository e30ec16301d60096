import {
  type AreaConvention,
  areaWeights,
  DEFAULT_AREA_SIZE,
  FurrowError,
  type GrayImage,
  resampleGray,
  type WrinkleSetDocument,
} from 'furrow'
import type { Progress } from '../progress.ts'
import { AREAS_PER_SLICE, areaArray, mapArrays } from './arrays.ts'
import type { AreaPlace, LayerImages, PackedWrinkles } from './embed.ts'
import { readBeside } from './folder.ts'
import {
  type CheckedImage,
  checkMap,
  checkOneSize,
  readGray,
  type Share,
  scaleMap,
  shareImages,
} from './map-images.ts'

/** How the images go into the file. */
export interface PackOptions {
  /** Areas to an image; those of a KTX 2 array lie four to a slice. */
  share: Share
  /** Whether maps and areas become KTX 2 arrays. */
  ktx2: boolean
  /** Side of the areas; the document's, or 128, unless told. */
  areaSize?: number
  /** Side that the layers' maps are scaled to; as they are unless told. */
  size?: number
}

/** What a folder becomes: its images as a file holds them, and what the user should know. */
export interface PackedFolder extends PackedWrinkles {
  /** Side of the areas. */
  areaSize: number
  warnings: string[]
}

/**
 * Turns a wrinkle set and its images into what goes into a file.
 *
 * @throws FurrowError at the first image that cannot be used, or name that does not fit.
 */
export async function packFolder(
  folder: string,
  document: WrinkleSetDocument,
  { share, ktx2, areaSize, size }: PackOptions,
  who: string,
  progress: Progress,
): Promise<PackedFolder> {
  const side = areaSize ?? document.areaSize ?? DEFAULT_AREA_SIZE
  const total = document.layers.length + document.areas.length + (ktx2 ? 2 : 0)
  let done = 0
  const step = () => progress(++done, total)
  const warnings: string[] = []
  const maps = await packLayers(folder, document.layers, size, who, step)

  const weights: GrayImage[] = []
  for (const { name, image, convention } of document.areas) {
    weights.push(await readWeights(folder, image, convention, side, who))
    if (weights.at(-1)!.data.every((value) => value === 0)) {
      warnings.push(`${who}: area "${name}" is visible nowhere; is ${image} in the other convention?`)
    }
    step()
  }
  const layers = ktx2 ? await mapArrays(maps, who) : maps
  if (ktx2) step()
  const images = ktx2 ? await areaArray(weights, who) : await shareImages(weights, share)
  if (ktx2) step()
  const perImage = ktx2 ? AREAS_PER_SLICE : share
  const areas = document.areas.map(({ name, layer, combine, activation }, i): AreaPlace => {
    const place = { image: images[Math.floor(i / perImage)], channel: i % perImage }
    return { name, ...place, layer: layerIndex(document, layer, name, who), combine, activation }
  })
  return { layers, areas, drivers: document.drivers ?? [], areaSize: side, warnings }
}

async function packLayers(
  folder: string,
  layers: WrinkleSetDocument['layers'],
  size: number | undefined,
  who: string,
  step: () => void,
): Promise<(LayerImages & { normal: CheckedImage })[]> {
  // Maps that are the same file, or the same bytes, go in once.
  const known = new Map<string, CheckedImage>()
  const load = async (address: string | undefined, name: string, kind: 'normals' | 'values' = 'values') => {
    if (address === undefined) return undefined
    const bytes = await readBeside(folder, address, who)
    const key = `${kind} ${Buffer.from(bytes).toString('latin1')}`
    const image = known.get(key) ?? (await scaledTo(size, await checkMap(bytes, name, address, who), kind))
    known.set(key, image)
    return image
  }
  const packed: (LayerImages & { normal: CheckedImage })[] = []
  for (const { name, normal, baseColor, roughness, occlusion, height, ...rest } of layers) {
    packed.push({
      ...rest,
      name,
      normal: (await load(normal, `${name} normal`, 'normals'))!,
      baseColor: await load(baseColor, `${name} base colour`),
      roughness: await load(roughness, `${name} roughness`),
      occlusion: await load(occlusion, `${name} occlusion`),
      height: await load(height, `${name} height`),
    })
    step()
  }
  checkOneSize(
    packed.map(({ normal }) => normal),
    'normal',
    who,
  )
  return packed
}

async function scaledTo(size: number | undefined, image: CheckedImage, kind: 'normals' | 'values') {
  return size === undefined ? image : scaleMap(image, size, kind)
}

async function readWeights(
  folder: string,
  address: string,
  convention: AreaConvention | undefined,
  size: number,
  who: string,
): Promise<GrayImage> {
  const painted = await readGray(await readBeside(folder, address, who), address, who)
  return resampleGray(areaWeights(painted, convention, `${who}: ${address}`), size)
}

function layerIndex({ layers }: WrinkleSetDocument, name: string | undefined, area: string, who: string) {
  const index = name === undefined ? 0 : layers.findIndex((layer) => layer.name === name)
  if (index >= 0) return index
  throw new FurrowError({
    who,
    what: `area "${area}" is on an unknown layer`,
    value: name,
    limit: layers.map((layer) => layer.name).join(', '),
    remedy: 'name one of the layers',
  })
}
