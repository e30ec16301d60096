import {
  type AreaConvention,
  areaWeights,
  DEFAULT_AREA_SIZE,
  FurrowError,
  type GrayImage,
  isMorphDriver,
  MorphActivation,
  resampleGray,
  type WrinkleSetDocument,
} from 'furrow'
import type { Progress } from '../progress.ts'
import type { AreaPlace, FileImage, LayerImages, PackedWrinkles } from './embed.ts'
import { readBeside } from './folder.ts'
import { type CheckedImage, checkMap, encodeShared, readGray } from './map-images.ts'

/** How many areas may share one image. */
export type Share = 1 | 3 | 4

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
  share: Share,
  areaSize: number | undefined,
  who: string,
  progress: Progress,
): Promise<PackedFolder> {
  const size = areaSize ?? document.areaSize ?? DEFAULT_AREA_SIZE
  const total = document.layers.length + document.areas.length
  let done = 0
  const step = () => progress(++done, total)
  const warnings: string[] = []
  const layers = await packLayers(folder, document.layers, who, step)

  const weights: GrayImage[] = []
  for (const { name, image, convention } of document.areas) {
    weights.push(await readWeights(folder, image, convention, size, who))
    if (weights.at(-1)!.data.every((value) => value === 0)) {
      warnings.push(`${who}: area "${name}" is visible nowhere; is ${image} in the other convention?`)
    }
    step()
  }
  const images = await shareImages(weights, share)
  const areas = document.areas.map(({ name, layer, combine, activation }, i): AreaPlace => {
    const place = { image: images[Math.floor(i / share)]!, channel: i % share }
    return { name, ...place, layer: layerIndex(document, layer, name, who), combine, activation }
  })
  return { layers, areas, drivers: document.drivers ?? [], areaSize: size, warnings }
}

/** What drivers name and the mesh does not have; they count as 0, so this is worth a warning and no more. */
export function unknownTargets(drivers: PackedWrinkles['drivers'], targetNames: readonly string[]): string[] {
  return [...new MorphActivation(drivers.filter(isMorphDriver), targetNames).unknownTargets]
}

async function packLayers(
  folder: string,
  layers: WrinkleSetDocument['layers'],
  who: string,
  step: () => void,
): Promise<LayerImages[]> {
  // Maps that are the same file, or the same bytes, go in once.
  const known = new Map<string, CheckedImage>()
  const load = async (address: string | undefined, name: string) => {
    if (address === undefined) return undefined
    const bytes = await readBeside(folder, address, who)
    const key = Buffer.from(bytes).toString('latin1')
    const image = known.get(key) ?? (await checkMap(bytes, name, address, who))
    known.set(key, image)
    return image
  }
  const packed: (LayerImages & { normal: CheckedImage })[] = []
  for (const { name, normal, baseColor, roughness, occlusion, height, ...rest } of layers) {
    packed.push({
      ...rest,
      name,
      normal: (await load(normal, `${name} normal`))!,
      baseColor: await load(baseColor, `${name} base colour`),
      roughness: await load(roughness, `${name} roughness`),
      occlusion: await load(occlusion, `${name} occlusion`),
      height: await load(height, `${name} height`),
    })
    step()
  }
  const sizes = packed.map(({ normal }) => `${normal.width} x ${normal.height}`)
  if (new Set(sizes).size > 1) {
    throw new FurrowError({
      who,
      what: 'the normal maps of the layers differ in size',
      value: sizes.join(', '),
      limit: 'one size for all layers',
      remedy: 'scale them to one size',
    })
  }
  return packed
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

function shareImages(weights: readonly GrayImage[], share: Share): Promise<FileImage[]> {
  const groups = Array.from({ length: Math.ceil(weights.length / share) }, (_, i) => {
    return encodeShared(weights.slice(i * share, (i + 1) * share), `areas ${i + 1}`)
  })
  return Promise.all(groups)
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
