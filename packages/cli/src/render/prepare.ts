import { access } from 'node:fs/promises'
import { dirname, join, parse, resolve } from 'node:path'
import { fileURLToPath, pathToFileURL } from 'node:url'
import {
  EXPRESSIONS,
  FurrowError,
  findTargets,
  parseWrinkleMaps,
  parseWrinkleSetDocument,
  WRINKLE_MAPS,
} from 'furrow'
import { cannotRead } from '../errors.ts'
import { readBytes, readJson } from '../files.ts'
import { decodeGlb } from '../gltf/glb-file.ts'
import { externalUris, type GltfJson, targetNamesOf } from '../gltf/gltf-json.ts'
import { type PageJob, PICTURE_DEFAULTS, PICTURE_SIDE, type PictureRequest } from './picture.ts'

const WHO = 'furrow render'

/** A request that was checked. */
export interface PreparedPicture {
  /** With all defaults applied; `face` and `wrinkles` are still paths. */
  job: Omit<PageJob, 'uploadTo'>
  /** Absolute paths of all files that the page may read. */
  files: string[]
}

/**
 * Checks a request and the files that it needs.
 *
 * @throws FurrowError at the first one that is missing, malformed, unknown or out of range.
 */
export async function preparePicture(request: PictureRequest): Promise<PreparedPicture> {
  const face = resolve(request.input)
  const job = { ...PICTURE_DEFAULTS, targets: {}, activations: {}, ...defined(request), face }
  if (job.expression !== undefined) {
    checkName(
      'expression',
      job.expression,
      EXPRESSIONS.map(({ name }) => name),
    )
  }
  checkSide('width', job.width)
  checkSide('height', job.height)
  const bytes = await readBytes(request.input, WHO, 'the face')
  const { json } = decodeGlb(bytes, request.input, WHO)
  const wrinkles = await findWrinkles(request, json)
  const targets = (json.meshes ?? []).map(targetNamesOf)
  checkWeights('blendshape', job.targets, [...new Set(targets.flat())], (name) =>
    targets.some((names) => findTargets(name, names).length > 0),
  )
  checkWeights('area', job.activations, wrinkles.areas, (name) => wrinkles.areas.includes(name))
  const files = [face, ...externalUris(json).map((uri) => resolveUri(face, uri)), ...wrinkles.files]
  await Promise.all(files.map(checkReadable))
  return { job: { ...job, wrinkles: wrinkles.path }, files }
}

/** The wrinkle set of the request, otherwise that of the face's file, otherwise that in the folder beside it. */
async function findWrinkles(
  request: PictureRequest,
  json: GltfJson,
): Promise<{ path?: string; areas: string[]; files: string[] }> {
  const own = json.materials?.map(({ extensions }) => extensions?.[WRINKLE_MAPS]).find(Boolean)
  if (own && request.wrinkles === undefined) {
    const { areas } = parseWrinkleMaps(own, json.textures?.length ?? 0, request.input)
    return { areas: areas.map(({ name }) => name), files: [] }
  }
  const path = resolve(request.wrinkles ?? defaultWrinkles(request.input))
  const { layers, areas } = parseWrinkleSetDocument(
    await readJson(path, WHO, 'the wrinkles', 'name the wrinkle set with --wrinkles'),
    path,
  )
  const images = [...layers.map(({ normal }) => normal), ...areas.map(({ image }) => image)]
  return {
    path,
    areas: areas.map(({ name }) => name),
    files: [path, ...images.map((uri) => resolveUri(path, uri))],
  }
}

/** `faces/human.glb` -> `faces/human/wrinkles.json`. */
function defaultWrinkles(input: string): string {
  const { name } = parse(input)
  return join(dirname(input), name, 'wrinkles.json')
}

function defined<T extends object>(options: T): T {
  return Object.fromEntries(Object.entries(options).filter(([, value]) => value !== undefined)) as T
}

function checkName(what: string, value: string, allowed: readonly string[]): void {
  if (allowed.includes(value)) return
  throw new FurrowError({
    code: 'unknown-name',
    who: WHO,
    what: `unknown ${what}`,
    value,
    limit: allowed.join(', '),
    remedy: 'use one of these',
  })
}

function checkSide(what: 'width' | 'height', value: number): void {
  const { min, max } = PICTURE_SIDE
  if (Number.isInteger(value) && value >= min && value <= max) return
  throw new FurrowError({
    code: 'out-of-range',
    who: WHO,
    what: `${what} out of range`,
    value,
    limit: `integers from ${min} to ${max} pixels`,
    remedy: 'choose e.g. --size 800x600',
  })
}

function checkWeights(
  what: string,
  weights: Record<string, number>,
  names: string[],
  known: (name: string) => boolean,
): void {
  for (const [name, weight] of Object.entries(weights)) {
    if (!known(name)) checkName(what, name, names.length > 0 ? names : ['this face has none'])
    if (weight >= 0 && weight <= 1) continue
    throw new FurrowError({
      code: 'out-of-range',
      who: WHO,
      what: `${what} ${name} out of range`,
      value: weight,
      limit: '0..1',
      remedy: `write e.g. ${name}=0.5`,
    })
  }
}

/** Resolves an address in a file as a browser would. Only files are read, nothing from the network. */
function resolveUri(path: string, uri: string): string {
  try {
    return fileURLToPath(new URL(uri, pathToFileURL(path)))
  } catch (error) {
    throw new FurrowError(
      {
        code: 'unreadable',
        who: WHO,
        what: `${path} refers to a file that is not on this computer`,
        value: uri,
        limit: 'addresses relative to the file',
        remedy: 'put it beside the file',
      },
      { cause: error },
    )
  }
}

async function checkReadable(path: string): Promise<void> {
  try {
    await access(path)
  } catch (error) {
    throw cannotRead(WHO, path, error, { remedy: 'check that the file exists and may be read' })
  }
}
