import { FurrowError } from 'furrow'
import { AUTO_REGIONS, DENSE_REGIONS } from 'furrow/author'
import { AUTO_SIDES, MAX_NUMBER } from 'furrow/internal'
import {
  AUTO_AGES,
  AUTO_DENSITIES,
  AUTO_SIZES,
  AUTO_STRENGTHS,
  AUTO_SYMMETRIES,
  type AutoSettings,
} from '../document/document.ts'
import { type LightDirection, MAX_LIGHT } from '../viewer/light-direction.ts'

/** State of the studio that fits into a URL. Contains the address of the model, not the model. */
export interface Link {
  /** Public URL of the model. Undefined for dropped files. */
  model?: string | undefined
  /** Blendshape weights, 0..1. Missing ones are 0. */
  pose?: ReadonlyMap<string, number> | undefined
  /** Position and target of the camera, scene units. */
  camera?: readonly [x: number, y: number, z: number, tx: number, ty: number, tz: number] | undefined
  /** Direction of the key light. Undefined means the default direction. */
  light?: LightDirection | undefined
  auto?: AutoSettings | undefined
}

/** Maximum number of characters in a link, an address and a name, and maximum number of blendshapes. */
const MAX = { link: 20_000, address: 2000, name: 100, weights: 500 } as const
/** Maximum absolute camera coordinate. */
const MAX_COORDINATE = 1e6
/** Largest random seed, a 32-bit integer. */
const MAX_SEED = 2 ** 32 - 1

/**
 * Formats a link as a URL hash without `#`, for example
 * `model=faces/human.glb&pose=jawOpen:0.25&camera=0,1.6,0.5,0,1.6,0&light=60,20&auto=45,1,1024,1`. The values of `auto` are age, strength,
 * map size, seed and, optionally, regions of the face. Optional parts are `lines=chin:2` (seeds of regions), `strengths=chin:0.5`,
 * `densities=nose:2` and `symmetry=0.5`.
 *
 * @param base page URL. If the model is below the page's folder, its address in the link is relative.
 */
export function formatLink({ model, pose, camera, light, auto }: Link, base: string): string {
  const parts: string[] = []
  const add = (name: string, text: string) => parts.push(`${name}=${text}`)
  if (model !== undefined) add('model', escaped(relative(model, base)))
  if (pose) {
    const weights = [...pose].filter(([, weight]) => weight > 0)
    add('pose', weights.map(([name, weight]) => `${escaped(name)}:${Number(weight.toFixed(3))}`).join(','))
  }
  if (camera) add('camera', camera.map((value) => Number(value.toPrecision(5))).join(','))
  if (light) add('light', `${light.yaw},${light.pitch}`)
  if (auto) {
    const { age, strength, size, seed, symmetry = 0, regions = [], seeds, strengths, densities } = auto
    add('auto', [age ?? '', strength, size, seed ?? '', ...regions].join(','))
    for (const [name, values] of Object.entries({ lines: seeds, strengths, densities })) {
      const entries = Object.entries(values ?? {}).map(([region, own]) => `${region}:${own}`)
      if (entries.length > 0) add(name, entries.join(','))
    }
    if (symmetry > 0) add('symmetry', `${symmetry}`)
  }
  return parts.join('&')
}

/**
 * Parses an untrusted link. The address of the model must begin with `https:` or have the origin of the page.
 *
 * @param hash with or without `#`.
 * @param base page URL.
 * @throws FurrowError for the first invalid part, such as a number out of range. Unknown parts are ignored.
 */
export function parseLink(hash: string, base: string): Link {
  const text = hash.replace(/^#/, '')
  if (text.length > MAX.link) throw unusableError('it is too long', text.length, `${MAX.link} characters`)
  const parts = new Map(
    text.split('&').map((part): [string, string] => {
      const [name, ...rest] = part.split('=')
      return [name, rest.join('=')]
    }),
  )
  const read = <T>(name: string, parse: (text: string) => T): T | undefined => {
    const part = parts.get(name)
    return part === undefined ? undefined : parse(part)
  }
  const auto = read('auto', autoOf)
  const seeds = read('lines', (part) => byRegion(part, AUTO_REGIONS, seedIn))
  const strengths = read('strengths', (part) =>
    byRegion(part, AUTO_SIDES, (text) => numberIn(text, 'its strength', AUTO_STRENGTHS[0], MAX_NUMBER)),
  )
  const densities = read('densities', (part) =>
    byRegion(part, DENSE_REGIONS, (text) => numberIn(text, 'its number of lines', ...AUTO_DENSITIES)),
  )
  const symmetry = read('symmetry', (part) => numberIn(part, 'its symmetry', ...AUTO_SYMMETRIES))
  return {
    model: read('model', (part) => addressOf(unescaped(part), base)),
    pose: read('pose', poseOf),
    camera: read('camera', cameraOf),
    light: read('light', lightOf),
    auto: auto && {
      ...auto,
      ...(seeds && { seeds }),
      ...(strengths && { strengths }),
      ...(densities && { densities }),
      ...(symmetry !== undefined && { symmetry }),
    },
  }
}

function addressOf(text: string, base: string): string {
  const fail = () =>
    unusableError('the address of its model', text.slice(0, MAX.name), 'an https URL, or a URL on this site')
  if (text.length > MAX.address || !URL.canParse(text, base)) throw fail()
  const url = new URL(text, base)
  const isAllowed = url.protocol === 'https:' || url.origin === new URL(base).origin
  if (!isAllowed || url.origin === 'null' || url.username || url.password) throw fail()
  return url.href
}

function poseOf(text: string): ReadonlyMap<string, number> {
  const entries = text === '' ? [] : text.split(',')
  if (entries.length > MAX.weights)
    throw unusableError('its pose', entries.length, `${MAX.weights} blendshapes`)
  return new Map(
    entries.map((entry): [string, number] => {
      const [name, weight, ...others] = entry.split(':')
      const plain = unescaped(name)
      if (plain === '' || plain.length > MAX.name || others.length > 0) {
        throw unusableError('its pose', entry.slice(0, MAX.name), 'NAME:WEIGHT')
      }
      return [plain, numberIn(weight, `the weight of ${plain}`, 0, 1)]
    }),
  )
}

function cameraOf(text: string): Link['camera'] {
  const values = text
    .split(',')
    .map((value) => numberIn(value, 'its camera', -MAX_COORDINATE, MAX_COORDINATE))
  const [x, y, z, tx, ty, tz] = values
  const distance = Math.hypot(x - tx, y - ty, z - tz)
  // If the camera looks straight up or down, its up direction is undefined.
  const isUpright = Math.hypot(x - tx, z - tz) > 1e-3 * distance
  if (values.length !== 6 || !isUpright)
    throw unusableError('its camera', text.slice(0, MAX.name), '6 numbers of a view that is not vertical')
  return [x, y, z, tx, ty, tz]
}

function lightOf(text: string): LightDirection {
  const [yaw, pitch, ...others] = text.split(',')
  if (others.length > 0) throw unusableError('its light', text.slice(0, MAX.name), '2 numbers')
  const [mostYaw, mostPitch] = MAX_LIGHT
  return {
    yaw: numberIn(yaw, 'its light', -mostYaw, mostYaw),
    pitch: numberIn(pitch, 'its light', -mostPitch, mostPitch),
  }
}

function autoOf(text: string): AutoSettings {
  const [age, strength, size, seed, ...regions] = text.split(',')
  const side = numberIn(size, 'its size', AUTO_SIZES[0], AUTO_SIZES.at(-1)!)
  if (!AUTO_SIZES.includes(side as never)) throw unusableError('its size', side, AUTO_SIZES.join(', '))
  for (const region of regions) checkRegion(region, AUTO_REGIONS)
  return {
    ...(age !== '' && { age: numberIn(age, 'its age', ...AUTO_AGES) }),
    strength: numberIn(strength, 'its strength', ...AUTO_STRENGTHS),
    size: side,
    ...(seed && { seed: seedIn(seed) }),
    ...(regions.length > 0 && { regions: AUTO_REGIONS.filter((region) => regions.includes(region)) }),
  }
}

function byRegion(
  text: string,
  names: readonly string[],
  parse: (value: string | undefined) => number,
): Record<string, number> {
  return Object.fromEntries(
    text.split(',').map((entry) => {
      const [region, value] = entry.split(':')
      checkRegion(region, names)
      return [region, parse(value)]
    }),
  )
}

function checkRegion(region: string, names: readonly string[]): void {
  if (names.includes(region)) return
  throw unusableError('its region', region.slice(0, MAX.name), names.join(', '))
}

function seedIn(text: string | undefined): number {
  const seed = numberIn(text, 'its seed', 0, MAX_SEED)
  if (Number.isInteger(seed)) return seed
  throw unusableError('its seed', text, 'a whole number')
}

function numberIn(text: string | undefined, problem: string, low: number, high: number): number {
  const value = Number(text || Number.NaN)
  if (value >= low && value <= high) return value
  throw unusableError(problem, text?.slice(0, MAX.name), `${low} to ${high}`)
}

/** Makes the address of a model relative if the model is below the page's folder. */
function relative(address: string, base: string): string {
  const folder = new URL('.', base).href
  return address.startsWith(folder) ? address.slice(folder.length) : address
}

/** Escapes text for a link. Keeps `/`, which is allowed in a URL hash and easier to read. */
function escaped(text: string): string {
  return encodeURIComponent(text).replaceAll('%2F', '/')
}

function unescaped(text: string): string {
  try {
    return decodeURIComponent(text)
  } catch {
    throw unusableError('a %-escape in it is invalid', text.slice(0, MAX.name))
  }
}

function unusableError(problem: string, value: unknown, limit?: string): FurrowError {
  return new FurrowError({
    code: 'out-of-range',
    who: 'Studio',
    problem: `the link cannot be used: ${problem}`,
    value,
    limit,
    remedy: 'ask for the link again, or open an avatar yourself',
  })
}
