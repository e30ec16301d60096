import { JsonReader } from '../../core/json.ts'
import { AUTO_REGIONS } from './anatomy/region-names.ts'
import { type AutoOptions, checkAutoOptions } from './options.ts'

const FIELDS = [
  'age',
  'strength',
  'symmetry',
  'seed',
  'seeds',
  'strengths',
  'densities',
  'regions',
] as const satisfies (keyof AutoOptions)[]

/** Options of `autoWrinkles` that apply to any face, because they name parts of the face and contain no lengths. */
export type AutoPreset = Pick<AutoOptions, (typeof FIELDS)[number]>

/**
 * Reads a preset (docs/auto.md): `{ "version": 1, "age": 60, "strengths": { "crowsFeet": 0.5 } }`. Missing fields have the defaults of
 * `autoWrinkles`.
 *
 * @param who name of the caller in errors.
 * @throws FurrowError for the first field that is malformed or unknown.
 */
export function parseAutoPreset(json: unknown, who = 'parseAutoPreset'): AutoPreset {
  const read = new JsonReader(who)
  const { version, ...preset } = read.object(json, 'the preset', ['version', ...FIELDS])
  if (version !== 1) read.fail('unknown version of the preset', version, '1', 'write "version": 1')
  for (const name of ['seeds', 'strengths', 'densities'])
    if (preset[name] !== undefined) read.object(preset[name], name)
  if (preset.regions !== undefined) read.array(preset.regions, 'regions', 0, AUTO_REGIONS.length)
  checkAutoOptions(preset, who)
  return preset
}
