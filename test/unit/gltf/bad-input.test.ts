import type { JSONDocument } from '@gltf-transform/core'
import fc from 'fast-check'
import { FurrowError } from 'furrow'
import { parseWrinkleMaps, type WrinkleMaps } from 'furrow/internal'
import { beforeAll, describe, expect, it } from 'vitest'
import { MUTATED, mutate, mutation } from './mutations.ts'
import { createIO, createSample, NAME } from './sample.ts'

// biome-ignore lint/suspicious/noExplicitAny: invalid on purpose
type Anything = any

const io = createIO()
let written: JSONDocument
let valid: Anything

beforeAll(async () => {
  written = await io.writeJSON(await createSample())
  valid = written.json.materials![0].extensions![NAME]
})

/**
 * Reads the sample with one field set, or removed if `value` is undefined. A path such as `areas.0.channel` is in the extension, and a path
 * such as `/textures.8` in the file.
 */
function readWith(path: string, value: Anything) {
  const json = structuredClone(written.json) as Anything
  const root = path.startsWith('/') ? json : json.materials[0].extensions[NAME]
  const keys = path.replace('/', '').split('.')
  const parent = keys.slice(0, -1).reduce((at, key) => at[key], root)
  if (value === undefined) delete parent[keys.at(-1)!]
  else parent[keys.at(-1)!] = value
  return io.readJSON({ json, resources: written.resources })
}

describe('a file with an invalid field', () => {
  it.each<[string, Anything, string]>([
    [`/materials.0.extensions.${NAME}`, [], 'the extension must be an object, got []'],
    [`/materials.0.extensions.${NAME}`, null, 'the extension must be an object, got null'],
    ['layers', undefined, 'layers must be an array, got nothing'],
    ['layers', [1, 2, 3, 4, 5], 'layers has the wrong number of items, got 5'],
    ['areas', [], 'areas has the wrong number of items, got 0'],
    ['layers.0.name', undefined, 'layers[0].name must be text'],
    ['layers.1.name', 'up', 'layers[1].name is taken, got "up"'],
    ['layers.0.kind', 'add', 'layers[0].kind is unknown, got "add"'],
    ['layers.1.normalTexture', undefined, 'layers[1].normalTexture must be an object'],
    ['layers.0.normalTexture.scale', 1e9, 'layers[0].normalTexture.scale is out of range'],
    ['layers.0.heightTexture.amplitude', undefined, 'layers[0].heightTexture.amplitude must be a number'],
    ['layers.0.bloodTexture.amplitude', undefined, 'layers[0].bloodTexture.amplitude must be a number'],
    ['layers.0.bloodTexture.amplitude', 2.5, 'layers[0].bloodTexture.amplitude is out of range'],
    [
      'layers.0.bloodTexture.index',
      4,
      'layers[0].bloodTexture differs from occlusionTexture, got "4", allowed: 5',
    ],
    [
      'layers.0.onsetTexture.index',
      4,
      'layers[0].onsetTexture differs from occlusionTexture, got "4", allowed: 5; store onset in the G channel of the occlusion image',
    ],
    [
      'layers.0.roughnessTexture.index',
      5,
      'layers[0].onsetTexture is the image of roughnessTexture, got "5", allowed: another image',
    ],
    ['layers.0.onsetTexture.strength', 2, 'layers[0].onsetTexture.strength is out of range'],
    ['layers.0.occlusionTexture.strength', 2, 'layers[0].occlusionTexture.strength is out of range'],
    ['areas.2.texture.index', 10, 'areas[2].texture.index is out of range, got 10, allowed: 0..9'],
    ['areas.2.texture.index', 1.5, 'areas[2].texture.index must be a whole number'],
    ['areas.0.layer', 2, 'areas[0].layer is out of range, got 2, allowed: 0..1'],
    ['areas.0.channel', 4, 'areas[0].channel is out of range, got 4'],
    ['areas.1.name', 'brow', 'areas[1].name is taken, got "brow"'],
    ['areas.0.combine', 'min', 'areas[0].combine is unknown, got "min"'],
    ['areas.0.activation', null, 'areas[0].activation must be a number'],
    ['areas.0.activation', 2, 'areas[0].activation is out of range'],
    ['drivers', {}, 'drivers must be an array'],
    ['drivers.0.type', undefined, 'drivers[0].type must be text'],
    ['drivers.0.area', 'x', 'drivers[0].area is unknown, got "x"'],
    ['drivers.0.targets', [], 'drivers[0].targets has the wrong number'],
    ['drivers.4.axis', [0, 0, 0], 'drivers[4].axis has length zero, got "0, 0, 0"; write e.g. [1, 0, 0]'],
    ['drivers.5.direction', [0, 0], 'drivers[5].direction has length zero, got "0, 0"; write e.g. [1, 0]'],
    ['drivers.5.direction', [1], 'drivers[5].direction has the wrong number of items, got 1'],
    ['drivers.0.curve.1.0', 0, 'drivers[0].curve[1][0] does not increase'],
    ['/textures.8.source', undefined, 'texture without a readable image, got 8'],
    ['/textures.8.sampler', 9, 'sampler is missing at texture 8'],
    ['areas.0.texture.texCoord', '0', 'texCoord is not an index at texture 8'],
    ['areas.0.texture.extras', 1, 'extras are not an object at texture 8'],
  ])('is refused with its name: %s = %j', async (path, value, message) => {
    const failure = await readWith(path, value).catch((error) => error)
    expect(failure).toBeInstanceOf(FurrowError)
    expect(failure.message).toContain(`${NAME} of material 0 "skin": ${message}`)
    expect(failure.message).not.toContain('\n')
  })

  it('is read if the field is unknown', async () => {
    await expect(readWith('areas.0.later', { texture: 1 })).resolves.toBeDefined()
  })

  it('is refused, also if its value is nested too deeply to print', () => {
    const deep = JSON.parse('['.repeat(50_000) + ']'.repeat(50_000))
    expect(() => parseWrinkleMaps({ layers: { deep } })).toThrow(FurrowError)
  })
})

describe('a truncated file', () => {
  it('is refused, at each percent of its length', async () => {
    const bytes = await io.writeBinary(await createSample())
    await expect(io.readBinary(bytes)).resolves.toBeDefined()
    for (let percent = 0; percent < 100; percent++) {
      const part = bytes.slice(0, Math.floor((bytes.length * percent) / 100))
      await expect(io.readBinary(part), `${percent}%`).rejects.toBeInstanceOf(Error)
    }
  })
})

/** Checks the rules of the extension, without the parser. */
function isValid({ layers, areas, drivers }: WrinkleMaps, textures: number): boolean {
  const text = (value: unknown) => typeof value === 'string' && value.length > 0 && value.length <= 256
  const within = (value: unknown, low: number, high: number) =>
    typeof value === 'number' && value >= low && value <= high
  const index = (value: unknown, count: number) => Number.isInteger(value) && within(value, 0, count - 1)
  const distinct = (named: { name: string }[]) => new Set(named.map(({ name }) => name)).size === named.length
  return (
    within(layers.length, 1, 4) &&
    within(areas.length, 1, 256) &&
    distinct(layers) &&
    distinct(areas) &&
    layers.every(
      (layer) =>
        text(layer.name) &&
        ['replace', 'detail'].includes(layer.kind) &&
        index(layer.normalTexture.index, textures) &&
        within(layer.normalTexture.scale, -1000, 1000) &&
        (!layer.baseColorTexture || index(layer.baseColorTexture.index, textures)) &&
        (!layer.roughnessTexture || index(layer.roughnessTexture.index, textures)) &&
        (!layer.occlusionTexture || within(layer.occlusionTexture.strength, 0, 1)) &&
        (!layer.heightTexture || within(layer.heightTexture.amplitude, 0, 1000)) &&
        (!layer.bloodTexture || within(layer.bloodTexture.amplitude, 0, 2)) &&
        (!layer.onsetTexture || within(layer.onsetTexture.strength, 0, 1)),
    ) &&
    areas.every(
      (area) =>
        text(area.name) &&
        index(area.layer, layers.length) &&
        index(area.texture.index, textures) &&
        index(area.channel, 4) &&
        ['sum', 'max'].includes(area.combine) &&
        within(area.activation, 0, 1),
    ) &&
    drivers.every((driver: Anything) => {
      if (!text(driver.type)) return false
      if (driver.type !== 'morph') return true
      return (
        areas.some(({ name }) => name === driver.area) &&
        driver.targets.length > 0 &&
        driver.targets.every((target: Anything) => text(target.name) && within(target.weight, -1000, 1000)) &&
        driver.curve.length > 1 &&
        driver.curve.every(
          ([input, output]: number[], i: number) =>
            within(output, 0, 1) && (i === 0 || input > driver.curve[i - 1][0]),
        )
      )
    })
  )
}

describe('parseWrinkleMaps', () => {
  it('returns a valid set or throws a FurrowError, for mutated documents', () => {
    const text = JSON.stringify(valid)
    let [accepted, refused] = [0, 0]
    fc.assert(
      fc.property(fc.array(mutation, { minLength: 1, maxLength: 4 }), (mutations) => {
        const document = mutations.reduce(mutate, JSON.parse(text))
        let maps: WrinkleMaps
        try {
          maps = parseWrinkleMaps(document, 10)
        } catch (error) {
          refused++
          return error instanceof FurrowError
        }
        accepted++
        return isValid(maps, 10)
      }),
      { numRuns: MUTATED, seed: 3 },
    )
    // Many documents must be refused and many accepted; otherwise the test proves nothing.
    expect(accepted).toBeGreaterThan(MUTATED / 20)
    expect(refused).toBeGreaterThan(MUTATED / 2)
  })

  it('parses its own output to the same set', () => {
    const maps = parseWrinkleMaps(valid, 10)
    expect(parseWrinkleMaps(JSON.parse(JSON.stringify(maps)), 10)).toEqual(maps)
  })
})
