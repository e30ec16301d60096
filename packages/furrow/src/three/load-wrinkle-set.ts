import { areaWeights } from '../core/area.ts'
import { parseWrinkleSetDocument } from '../core/document.ts'
import { FurrowError } from '../core/error.ts'
import type { Area, Layer, WrinkleSet } from '../core/types.ts'
import { checkWrinkleSet } from '../core/wrinkle-set.ts'
import { decodeImage, toGray } from './decode-image.ts'

/**
 * Loads a wrinkle set from its `wrinkles.json` and the images beside it.
 *
 * @param url address of the document, relative to the page.
 * @throws FurrowError when a file is missing, malformed or no image; nothing half-loaded is returned.
 */
export async function loadWrinkleSet(url: string): Promise<WrinkleSet> {
  const address = new URL(url, globalThis.location?.href)
  const document = parseWrinkleSetDocument(await readJson(address), url)
  const layers = document.layers.map(
    async ({ normal, ...layer }): Promise<Layer> => ({
      ...layer,
      normal: await decodeImage(await fetchFile(new URL(normal, address)), normal),
    }),
  )
  const areas = document.areas.map(
    async ({ image, convention, ...area }): Promise<Area> => ({
      ...area,
      weights: areaWeights(
        toGray(await decodeImage(await fetchFile(new URL(image, address)), image)),
        convention,
        image,
      ),
    }),
  )
  const set: WrinkleSet = { layers: await Promise.all(layers), areas: await Promise.all(areas) }
  checkWrinkleSet(set, url)
  return set
}

async function readJson(address: URL): Promise<unknown> {
  const text = await (await fetchFile(address)).text()
  try {
    return JSON.parse(text)
  } catch (error) {
    throw new FurrowError({
      who: address.pathname,
      what: 'not JSON',
      value: (error as Error).message,
      remedy: 'check the address and the file',
    })
  }
}

async function fetchFile(address: URL): Promise<Blob> {
  const response = await fetch(address)
  if (response.ok) return response.blob()
  throw new FurrowError({
    who: address.pathname,
    what: 'file not found',
    value: `HTTP status ${response.status}`,
    remedy: 'check that the server serves it at this address',
  })
}
