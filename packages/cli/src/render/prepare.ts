import { access, stat } from 'node:fs/promises'
import { dirname, join, parse, resolve } from 'node:path'
import { fileURLToPath, pathToFileURL } from 'node:url'
import { EXPRESSIONS, FurrowError, findTargets, parseWrinkleSetDocument } from 'furrow'
import { didYouMean, parseWrinkleMaps, WRINKLE_MAPS } from 'furrow/internal'
import { cannotRead, encodeGlb, type GltfJson, MAP_SLOTS, targetNamesOf } from 'furrow-files'
import { type ReadOptions, readGlbFile, readJson, recordRead, resolveInside } from 'furrow-files/node'
import { type PageJob, PICTURE_DEFAULTS, PICTURE_SIDE, type PictureRequest } from './picture.ts'

const WHO = 'furrow render'

/** Files that the page may read, by the path in the URL. A value is a file's bytes, or the path to read it from. */
export type ServedFiles = ReadonlyMap<string, Uint8Array | string>

export interface PreparedPicture {
  /** Job for the page, with defaults applied. `face` and `wrinkles` are still paths. */
  job: Omit<PageJob, 'uploadTo'>
  files: ServedFiles
  notes: string[]
}

interface EncodedFace {
  json: GltfJson
  bytes: Uint8Array
}

/** Returns a function that reads the face of a request. It caches faces by path. */
export function faceReader(): (request: PictureRequest) => Promise<EncodedFace> {
  const faces = new Map<string, Promise<EncodedFace>>()
  return ({ input, allowOutside }) => {
    const face =
      faces.get(input) ??
      readGlbFile(input, WHO, { allowOutside }).then((glb) => ({ json: glb.json, bytes: encodeGlb(glb) }))
    faces.set(input, face)
    return face
  }
}

/**
 * Validates a request and its files.
 *
 * @throws FurrowError for the first value that is invalid, unknown, out of range or missing.
 */
export async function preparePicture(
  { allowOutside, ...request }: PictureRequest,
  readFace = faceReader(),
): Promise<PreparedPicture> {
  const face = resolve(request.input)
  const job = { ...PICTURE_DEFAULTS, targets: {}, joints: {}, activations: {}, ...defined(request), face }
  if (job.expression !== undefined) {
    checkName(
      'expression',
      job.expression,
      EXPRESSIONS.map(({ name }) => name),
    )
  }
  checkSide('width', job.width)
  checkSide('height', job.height)
  const { json, bytes } = await readFace({ ...request, allowOutside })
  const wrinkles = await findWrinkles(request, json, { allowOutside })
  const targets = (json.meshes ?? []).map(targetNamesOf)
  checkWeights('blendshape', job.targets, [...new Set(targets.flat())], (name) =>
    targets.some((names) => findTargets(name, names).length > 0),
  )
  const areas = wrinkles?.areas ?? []
  checkWeights('area', job.activations, areas, (name) => areas.includes(name))
  return {
    job: { ...job, wrinkles: wrinkles?.path },
    files: new Map([[face, bytes], ...(wrinkles?.files ?? [])]),
    notes: wrinkles ? [] : [`${WHO}: ${request.input} has no wrinkles; add them with furrow auto`],
  }
}

interface FoundWrinkles {
  /** Path of the wrinkle set, if it is not in the face. */
  path?: string
  areas: string[]
  files: ServedFiles
}

/** Finds the wrinkle set that the request names. Default: the set in the face, or in the folder beside the face. */
async function findWrinkles(
  request: PictureRequest,
  json: GltfJson,
  options: ReadOptions,
): Promise<FoundWrinkles | undefined> {
  const own = json.materials?.map(({ extensions }) => extensions?.[WRINKLE_MAPS]).find(Boolean)
  if (own && request.wrinkles === undefined) {
    const { areas } = parseWrinkleMaps(own, json.textures?.length ?? 0, `${WHO}: ${request.input}`)
    return { areas: areas.map(({ name }) => name), files: new Map() }
  }
  const path = resolve(request.wrinkles ?? defaultWrinkles(request.input))
  if (request.wrinkles === undefined && !(await exists(path))) return undefined
  const { layers, areas } = parseWrinkleSetDocument(
    await readJson(path, WHO, 'the wrinkles'),
    `${WHO}: ${path}`,
  )
  const files = new Map([[path, path]])
  const maps = layers.flatMap((layer) => MAP_SLOTS.flatMap(([map]) => layer[map] ?? []))
  for (const uri of [...maps, ...areas.map(({ image }) => image)]) {
    const real = await resolveInside(path, uri, WHO, options)
    await checkReadable(real)
    // The page reads this file later, so no output may overwrite it.
    recordRead(await stat(real, { bigint: true }))
    // The key is the path to which the browser resolves the URI.
    files.set(fileURLToPath(new URL(uri, pathToFileURL(path))), real)
  }
  return { path, areas: areas.map(({ name }) => name), files }
}

/** Returns the default path of a wrinkle set, e.g. `faces/human/wrinkles.json` for `faces/human.glb`. */
function defaultWrinkles(input: string): string {
  const { name } = parse(input)
  return join(dirname(input), name, 'wrinkles.json')
}

async function exists(path: string): Promise<boolean> {
  return access(path).then(
    () => true,
    ({ code }) => code !== 'ENOENT' && code !== 'ENOTDIR',
  )
}

function defined<T extends object>(options: T): T {
  return Object.fromEntries(Object.entries(options).filter(([, value]) => value !== undefined)) as T
}

function checkName(kind: string, value: string, allowed: readonly string[]): void {
  if (allowed.includes(value)) return
  throw new FurrowError({
    code: 'unknown-name',
    who: WHO,
    problem: `unknown ${kind}`,
    value,
    limit: allowed.join(', '),
    remedy: didYouMean(value, allowed, 'choose one of these'),
  })
}

function checkSide(name: 'width' | 'height', value: number): void {
  const { min, max } = PICTURE_SIDE
  if (Number.isInteger(value) && value >= min && value <= max) return
  throw new FurrowError({
    code: 'out-of-range',
    who: WHO,
    problem: `${name} out of range`,
    value,
    limit: `integers from ${min} to ${max} pixels`,
    remedy: 'choose e.g. --size 800x600',
  })
}

function checkWeights(
  kind: string,
  weights: Record<string, number>,
  names: string[],
  known: (name: string) => boolean,
): void {
  for (const [name, weight] of Object.entries(weights)) {
    if (names.length === 0) throw noneError(kind, name)
    if (!known(name)) checkName(kind, name, names)
    if (weight >= 0 && weight <= 1) continue
    throw new FurrowError({
      code: 'out-of-range',
      who: WHO,
      problem: `${kind} ${name} out of range`,
      value: weight,
      limit: '0..1',
      remedy: `use e.g. ${name}=0.5`,
    })
  }
}

function noneError(kind: string, value: string): FurrowError {
  return new FurrowError({
    code: 'unknown-name',
    who: WHO,
    problem: `the face has no ${kind}s`,
    value,
    remedy: kind === 'area' ? 'add wrinkles with furrow auto, or omit --activation' : 'omit --set',
  })
}

async function checkReadable(path: string): Promise<void> {
  try {
    await access(path)
  } catch (error) {
    throw cannotRead(WHO, path, error, { remedy: 'check that the file exists and is readable' })
  }
}
