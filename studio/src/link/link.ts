import { FurrowError } from 'furrow'
import { AUTO_REGIONS } from 'furrow/author'
import type { AutoRegion } from 'furrow/auto'
import { AUTO_AGES, AUTO_SIZES, AUTO_STRENGTHS, type AutoSettings } from '../document/document.ts'
import { type LightDirection, MAX_LIGHT } from '../viewer/light-direction.ts'

/** Contents of a link: small settings, never the model itself. */
export interface Link {
  /** Model URL, if public. */
  model?: string | undefined
  /** Blendshape weights, 0..1. Missing ones are 0. */
  pose?: ReadonlyMap<string, number> | undefined
  /** Position and target in scene units. */
  camera?: readonly [x: number, y: number, z: number, tx: number, ty: number, tz: number] | undefined
  /** Light direction. Absent for the default. */
  light?: LightDirection | undefined
  /** Settings of automatic wrinkles. */
  auto?: AutoSettings | undefined
}

/** Maximum characters of a link, of an address and of a name, and maximum number of blendshapes. */
const MAX = { link: 20_000, address: 2000, name: 100, weights: 500 } as const
/** Maximum absolute camera coordinate. */
const MAX_COORDINATE = 1e6
/** Maximum 32-bit seed. */
const MAX_SEED = 2 ** 32 - 1

/**
 * Formats a link as a URL hash without `#`, for example
 * `model=faces/human.glb&pose=jawOpen:0.25&camera=0,1.6,0.5,0,1.6,0&light=60,20&auto=45,1,1024,1`. Regions can follow in `auto`, and
 * `lines=chin:2` has seeds per region.
 *
 * @param base page URL. Models below its folder get a relative address.
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
    const { age, strength, size, seed, regions = [], seeds = {} } = auto
    add('auto', [age ?? '', strength, size, seed, ...regions].join(','))
    const lines = Object.entries(seeds).map(([region, own]) => `${region}:${own}`)
    if (lines.length > 0) add('lines', lines.join(','))
  }
  return parts.join('&')
}

/**
 * Parses an untrusted link. Rejects numbers out of range, and addresses that are not https or of the page's origin.
 *
 * @param hash with or without `#`.
 * @param base page URL.
 * @throws FurrowError for the first invalid part. Unknown parts are ignored.
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
  const seeds = read('lines', seedsOf)
  return {
    model: read('model', (part) => addressOf(unescaped(part), base)),
    pose: read('pose', poseOf),
    camera: read('camera', cameraOf),
    light: read('light', lightOf),
    auto: auto && seeds ? { ...auto, seeds } : auto,
  }
}

function addressOf(text: string, base: string): string {
  const fail = () =>
    unusableError('the address of its model', text.slice(0, MAX.name), 'https, or beside this page')
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
  // Looking straight up or down leaves the up direction undefined.
  const isUpright = Math.hypot(x - tx, z - tz) > 1e-3 * distance
  if (values.length !== 6 || !isUpright)
    throw unusableError('its camera', text.slice(0, MAX.name), '6 numbers')
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
  for (const region of regions) checkRegion(region)
  return {
    ...(age !== '' && { age: numberIn(age, 'its age', ...AUTO_AGES) }),
    strength: numberIn(strength, 'its strength', ...AUTO_STRENGTHS),
    size: side,
    seed: seedIn(seed),
    ...(regions.length > 0 && { regions: AUTO_REGIONS.filter((region) => regions.includes(region)) }),
  }
}

function seedsOf(text: string): AutoSettings['seeds'] {
  return Object.fromEntries(
    text.split(',').map((entry) => {
      const [region, seed] = entry.split(':')
      checkRegion(region)
      return [region, seedIn(seed)]
    }),
  )
}

function checkRegion(region: string): void {
  if (AUTO_REGIONS.includes(region as AutoRegion)) return
  throw unusableError('its region', region.slice(0, MAX.name), AUTO_REGIONS.join(', '))
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

/** Makes an address relative if it is below the page's folder. */
function relative(address: string, base: string): string {
  const folder = new URL('.', base).href
  return address.startsWith(folder) ? address.slice(folder.length) : address
}

/** Escapes text for a link. Keeps `/`, which is safe in a hash and more readable. */
function escaped(text: string): string {
  return encodeURIComponent(text).replaceAll('%2F', '/')
}

function unescaped(text: string): string {
  try {
    return decodeURIComponent(text)
  } catch {
    throw unusableError('it is cut off', text.slice(0, MAX.name))
  }
}

function unusableError(problem: string, value: unknown, limit?: string): FurrowError {
  return new FurrowError({
    code: 'out-of-range',
    who: 'Studio',
    problem: `the link cannot be used: ${problem}`,
    value,
    limit,
    remedy: 'ask for it again, or go on without it',
  })
}
