import { areaWeights } from '../../core/area.ts'
import { CHANNEL, channelOf } from '../../core/channels.ts'
import type { SetDocument } from '../../core/document.ts'
import { FurrowError } from '../../core/error.ts'
import type { Area, Layer, WrinkleSet } from '../../core/types.ts'
import { checkWrinkleSet } from '../../core/wrinkle-set.ts'
import { parseWrinkleSetDocument } from '../../drivers/parse.ts'
import { decodeImage, toGray } from '../../runtime/file/decode-image.ts'

/**
 * Loads a wrinkle set, including drivers, from a `wrinkles.json` and its images. The document must list its layers and areas, because a page
 * cannot list the files in a folder.
 *
 * @param url address of the document, relative to the page.
 * @throws FurrowError if a file is missing or malformed.
 */
export async function loadWrinkleSet(url: string): Promise<WrinkleSet> {
  const base = new URL(url, globalThis.location?.href)
  const document = parseWrinkleSetDocument(await readJson(base), url)
  const { drivers } = document
  const set = await readImages(document, (file) => fetchFile(new URL(file, base)), url)
  return { ...set, ...(drivers && { drivers }) }
}

/**
 * Reads and decodes the images of a `wrinkles.json`.
 *
 * @param read reads an image by its address in the document.
 * @param who name of the document, for errors.
 * @throws FurrowError if an image cannot be decoded, or differs from the other images in size.
 */
export async function readImages(
  document: SetDocument,
  read: (address: string) => Promise<Blob>,
  who: string,
): Promise<Omit<WrinkleSet, 'drivers'>> {
  const image = async (address: string) => decodeImage(await read(address), address)
  const layers = document.layers.map(async (layer): Promise<Layer> => {
    const {
      name,
      kind,
      normalScale,
      occlusionStrength,
      baseColor,
      roughness,
      occlusion,
      blood,
      bloodAmplitude,
      onset,
      onsetStrength,
      height,
      heightAmplitude,
    } = layer
    return {
      name,
      kind,
      normal: await image(layer.normal),
      ...(normalScale !== undefined && { normalScale }),
      ...(baseColor && { baseColor: await image(baseColor) }),
      ...(roughness && { roughness: channelOf(await image(roughness), CHANNEL.roughness) }),
      ...(occlusion && { occlusion: channelOf(await image(occlusion), CHANNEL.occlusion) }),
      ...(occlusionStrength !== undefined && { occlusionStrength }),
      ...(blood && { blood: channelOf(await image(blood), CHANNEL.blood), bloodAmplitude }),
      ...(onset && { onset: channelOf(await image(onset), CHANNEL.onset) }),
      ...(onsetStrength !== undefined && { onsetStrength }),
      ...(height && { height: channelOf(await image(height), CHANNEL.height), heightAmplitude }),
    }
  })
  const areas = document.areas.map(
    async ({ image: address, convention, ...area }): Promise<Area> => ({
      ...area,
      weights: areaWeights(toGray(await image(address)), convention, address),
    }),
  )
  const set = { layers: await Promise.all(layers), areas: await Promise.all(areas) }
  checkWrinkleSet(set, who)
  return set
}

async function readJson(address: URL): Promise<unknown> {
  const text = await (await fetchFile(address)).text()
  try {
    return JSON.parse(text)
  } catch (error) {
    throw new FurrowError({
      code: 'unreadable',
      who: address.pathname,
      problem: 'not JSON',
      value: (error as Error).message,
      remedy: 'check the address and the file',
    })
  }
}

async function fetchFile(address: URL): Promise<Blob> {
  const response = await fetch(address)
  if (response.ok) return response.blob()
  throw new FurrowError({
    code: 'unreadable',
    who: address.pathname,
    problem: 'file not found',
    value: `HTTP status ${response.status}`,
    remedy: 'check that the server has the file at this address',
  })
}
