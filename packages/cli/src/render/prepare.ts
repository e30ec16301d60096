import { access, readFile } from 'node:fs/promises'
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
import { firstLine } from '../images.ts'
import { type GltfJson, outerFiles, readGlb, targetNames } from './glb.ts'
import {
  MODE_NAMES,
  type PageJob,
  PICTURE_DEFAULTS,
  PICTURE_SIDE,
  type PictureRequest,
  RENDERER_NAMES,
  VIEW_NAMES,
} from './picture.ts'

const WHO = 'furrow render'

/** A request that was found good, before any browser is started. */
export interface PreparedPicture {
  /** Every default filled in; `face` and `wrinkles` are paths still. */
  job: Omit<PageJob, 'deliver'>
  /** All files the page may read, as absolute paths. */
  files: string[]
}

/**
 * Reads what a picture needs and checks it.
 *
 * @throws FurrowError that names the first thing which is missing, malformed, unknown or out of range.
 */
export async function preparePicture(request: PictureRequest): Promise<PreparedPicture> {
  const face = resolve(request.input)
  const job = { ...PICTURE_DEFAULTS, targets: {}, activations: {}, ...defined(request), face }
  checkChoice('view', job.view, VIEW_NAMES)
  checkChoice('renderer', job.renderer, RENDERER_NAMES)
  checkChoice('mode', job.mode, MODE_NAMES)
  if (job.expression !== undefined) {
    checkChoice(
      'expression',
      job.expression,
      EXPRESSIONS.map(({ name }) => name),
    )
  }
  checkSide('width', job.width)
  checkSide('height', job.height)
  const gltf = await readGlb(request.input)
  const wrinkles = await findWrinkles(request, gltf)
  const targets = targetNames(gltf)
  checkWeights('blendshape', job.targets, [...new Set(targets.flat())], (name) =>
    targets.some((names) => findTargets(name, names).length > 0),
  )
  checkWeights('area', job.activations, wrinkles.areas, (name) => wrinkles.areas.includes(name))
  const files = [face, ...outerFiles(gltf).map((address) => beside(face, address)), ...wrinkles.files]
  await Promise.all(files.map(checkReadable))
  return { job: { ...job, wrinkles: wrinkles.path }, files }
}

/** The wrinkles asked for, else those in the face's file, else those in the folder beside it. */
async function findWrinkles(
  request: PictureRequest,
  gltf: GltfJson,
): Promise<{ path?: string; areas: string[]; files: string[] }> {
  const carried = gltf.materials?.map(({ extensions }) => extensions?.[WRINKLE_MAPS]).find(Boolean)
  if (carried && request.wrinkles === undefined) {
    const { areas } = parseWrinkleMaps(carried, gltf.textures?.length ?? 0, request.input)
    return { areas: areas.map(({ name }) => name), files: [] }
  }
  const path = resolve(request.wrinkles ?? usualWrinkles(request.input))
  const { layers, areas } = parseWrinkleSetDocument(await readJson(path), path)
  const images = [...layers.map(({ normal }) => normal), ...areas.map(({ image }) => image)]
  return {
    path,
    areas: areas.map(({ name }) => name),
    files: [path, ...images.map((address) => beside(path, address))],
  }
}

/** `faces/human.glb` -> `faces/human/wrinkles.json`. */
function usualWrinkles(input: string): string {
  const { name } = parse(input)
  return join(dirname(input), name, 'wrinkles.json')
}

function defined<T extends object>(options: T): T {
  return Object.fromEntries(Object.entries(options).filter(([, value]) => value !== undefined)) as T
}

function checkChoice(what: string, value: string, allowed: readonly string[]): void {
  if (allowed.includes(value)) return
  throw new FurrowError({
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
    who: WHO,
    what: `${what} out of range`,
    value,
    limit: `${min}..${max} whole pixels`,
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
    if (!known(name)) checkChoice(what, name, names.length > 0 ? names : ['this face has none'])
    if (weight >= 0 && weight <= 1) continue
    throw new FurrowError({
      who: WHO,
      what: `${what} ${name} out of range`,
      value: weight,
      limit: '0..1',
      remedy: `write e.g. ${name}=0.5`,
    })
  }
}

async function readJson(path: string): Promise<unknown> {
  let text: string
  try {
    text = await readFile(path, 'utf8')
  } catch (error) {
    throw new FurrowError({
      who: WHO,
      what: `cannot read the wrinkles ${path} (${firstLine(error)})`,
      remedy: 'name the wrinkle set with --wrinkles',
    })
  }
  try {
    return JSON.parse(text)
  } catch (error) {
    throw new FurrowError({
      who: WHO,
      what: `the wrinkles ${path} are no JSON (${firstLine(error)})`,
      remedy: 'correct the file',
    })
  }
}

/** A file named by another's address, as a browser would find it; only files are read, nothing off the network. */
function beside(path: string, address: string): string {
  try {
    return fileURLToPath(new URL(address, pathToFileURL(path)))
  } catch {
    throw new FurrowError({
      who: WHO,
      what: `${path} needs a file that is not on this computer`,
      value: address,
      limit: 'addresses relative to the file',
      remedy: 'put it beside the file',
    })
  }
}

async function checkReadable(path: string): Promise<void> {
  try {
    await access(path)
  } catch (error) {
    throw new FurrowError({
      who: WHO,
      what: `cannot read ${path} (${firstLine(error)})`,
      remedy: 'check the file and who may read it',
    })
  }
}
