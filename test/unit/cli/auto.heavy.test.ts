import { mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { SingleBar } from 'cli-progress'
import { parseStrokes } from 'furrow/author'
import { AUTO_STEPS, parseWrinkleMaps } from 'furrow/internal'
import sharp from 'sharp'
import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest'
import { editGlb, jsonOf } from '../../glb.ts'
import { PUSHED, type Sheet, writeSheet } from './sheet.ts'
import { bench } from './workshop.ts'

const NAME = 'FURROW_wrinkle_maps'
const at = bench('auto')
const { file, fails } = at

/** Runs the command with the smallest maps. The tests do not depend on the size. */
const run = (...args: string[]) => at.run(...args, '--size', '512')

const write = (name: string, spoil?: (shape: Sheet) => void) => writeSheet(file(name), spoil)

const areasOf = (path: string) => {
  const json = jsonOf(readFileSync(path))
  return parseWrinkleMaps(json.materials[0].extensions[NAME], json.textures.length).areas
}

describe('a body without a face', () => {
  test('gets wrinkles by strain alone, and the command says so', async () => {
    await run(await write('body.glb'), '-o', file('out.glb'))
    expect(at.printed).toMatch(
      /mesh "torso", material "cloth" \(the only surface with .+\); layers: 1; areas: [1-9]/,
    )
    expect(at.warned).toMatch(/^furrow auto: no face detected .*\n$/)
    expect(areasOf(file('out.glb'))[0].name).toBe('bend')
    expect(await at.shop.output('validate', file('out.glb'))).toContain('0 errors')
  })

  test('has no regions to choose', async () => {
    const body = await write('body.glb')
    await fails('regions require a face', body, '-o', file('x.glb'), '--regions', 'neck', 'chin')
  })

  test('gets the strength and the seed of a preset, unless an option overrides them', async () => {
    const body = await write('body.glb')
    const preset = at.shop.json('preset.json', { version: 1, seed: 2, strength: 0.5 })
    const depths = async (...options: string[]) => {
      await run(body, '-o', file('out.glb'), '--strokes', file('lines.json'), '--seed', '9', ...options)
      const { seed, strokes } = parseStrokes(JSON.parse(readFileSync(file('lines.json'), 'utf8')))
      expect(seed).toBe(9)
      return strokes.map(({ depth }) => depth)
    }
    const [plain, shallow] = [await depths(), await depths('--preset', preset)]
    expect(plain.length).toBeGreaterThan(0)
    expect(shallow).toHaveLength(plain.length)
    for (const [i, depth] of plain.entries()) expect(shallow[i] / depth).toBeCloseTo(0.5, 2)
  })

  test('is described as JSON', async () => {
    await run(await write('body.glb'), '-o', file('out.glb'), '--json')
    const told = JSON.parse(at.printed)
    expect(told).toEqual({
      file: file('out.glb'),
      mesh: 'torso',
      material: 'cloth',
      reason: expect.stringContaining('the only surface with'),
      bytes: readFileSync(file('out.glb')).length,
      cost: { file: expect.any(Number), gpu: expect.any(Number), phone: expect.any(Number) },
      total: { areas: told.areas.length, file: told.cost.file, gpu: told.cost.gpu },
      isFace: false,
      seed: 1,
      symmetry: 0,
      warnings: [expect.stringContaining('no face detected')],
      layers: ['auto1'],
      areas: expect.any(Array),
      jointAreas: [],
      areasWithoutLines: [],
      missing: [],
      others: [],
    })
    for (const area of told.areas) {
      expect(Object.keys(area)).toEqual(['name', 'layer', 'lines', 'compression', 'error', 'links'])
      expect(area.links).toEqual([{ name: 'bend', weight: expect.any(Number) }])
      expect(area.lines).toBeGreaterThan(0)
    }
    expect(
      Math.max(...told.areas.map(({ compression }: { compression: number }) => compression)),
    ).toBeCloseTo(PUSHED, 1)
  })
})

describe('bytes', () => {
  test('depend only on the input, the options and the seed', async () => {
    const face = await write('body.glb')
    for (const [name, seed] of [
      ['a', '1'],
      ['b', '1'],
      ['c', '2'],
    ])
      await run(face, '-o', file(`${name}.glb`), '--seed', seed!)
    const [a, b, c] = ['a', 'b', 'c'].map((name) => readFileSync(file(`${name}.glb`)))
    expect(a!.equals(b!)).toBe(true)
    expect(a!.equals(c!)).toBe(false)
  })

  test('of existing data in the file stay the same', async () => {
    const face = await write('body.glb')
    const odd = editGlb(readFileSync(face), (json) => {
      json.extensions = { ODD_thing: { texture: 0 } }
      json.extensionsUsed = ['ODD_thing']
      json.nodes[0].extras = { own: [1, null, 'ü'] }
      json.asset.generator = 'somebody'
    })
    writeFileSync(file('odd.glb'), odd)
    await run(file('odd.glb'), '-o', file('out.glb'))
    const [before, after] = [odd, readFileSync(file('out.glb'))]
    const json = jsonOf(after)
    const old = jsonOf(before)
    // In each list, the existing items come first, and those of the wrinkles follow.
    for (const list of ['images', 'textures', 'samplers', 'bufferViews']) {
      expect(json[list].length).toBeGreaterThan((old[list] ?? []).length)
      json[list] = json[list].slice(0, (old[list] ?? []).length)
      if (!old[list]) delete json[list]
    }
    delete json.materials[0].extensions
    json.extensionsUsed = json.extensionsUsed.filter((name: string) => name !== NAME)
    json.buffers[0].byteLength = old.buffers[0].byteLength
    expect(json).toEqual(old)
    const [was, is] = [binOf(before), binOf(after)]
    expect(is.subarray(0, was.length).equals(was)).toBe(true)
  })
})

describe('the report', () => {
  const page = (folder: string) => readFileSync(join(folder, 'index.html'), 'utf8')

  // Makes sure that no browser is available.
  beforeEach(() => void vi.stubEnv('FURROW_CHROMIUM', '/nowhere/chromium'))
  afterEach(() => void vi.unstubAllEnvs())

  test('is written without a browser, and says so', async () => {
    await run(await write('body.glb'), '-o', file('out.glb'), '--report', file('report'), '--json')
    expect(JSON.parse(at.printed).report).toBe(file('report/index.html'))
    expect(at.warned).toContain(
      'furrow auto: the report has no pictures of the face (furrow: FURROW_CHROMIUM',
    )
    const html = page(file('report'))
    expect(html).toContain('The face was not drawn.')
    expect(html).toContain('no face detected')
    const sources = [...html.matchAll(/<img src="([^"]+)"/g)].map(([, source]) => source!)
    const areas = areasOf(file('out.glb')).map((_, i) => `area-${i + 1}.webp`)
    const maps = ['strain-1.webp', ...areas, 'layer-1-normal.webp', 'layer-1-height.webp']
    expect(sources).toEqual(maps)
    expect(readdirSync(file('report')).sort()).toEqual([...maps, 'index.html'].sort())
    for (const source of sources)
      expect((await sharp(join(file('report'), source)).metadata()).format).toBe('webp')
  })

  test('escapes names from the file, and needs no script', async () => {
    const face = await write('odd.glb', ({ targets }) => {
      targets['<img src=x onerror=alert(1)>"&\n\''] = targets.bend!
      delete targets.bend
    })
    await run(face, '-o', file('out.glb'), '--report', file('odd'))
    const html = page(file('odd'))
    expect(html).toContain('&lt;img src=x onerror=alert(1)&gt;&quot;&amp; &#39;')
    expect(html).not.toMatch(/<img src=x|<script/)
    expect([...html.matchAll(/<img [^>]*>/g)].every(([tag]) => /alt="[^"]+"/.test(tag))).toBe(true)
  })

  test('is named after the face if the face goes to stdout, and messages go to stderr', async () => {
    const stderr = vi.spyOn(process.stderr, 'write').mockReturnValue(true)
    const chunks: Buffer[] = []
    vi.spyOn(process.stdout, 'write').mockImplementation(((bytes: Buffer, done: () => void) => {
      chunks.push(bytes)
      done()
      return true
    }) as never)
    await run(await write('body.glb'), '-o', '-', '--report', file('piped'))
    const told = stderr.mock.calls.join('')
    vi.mocked(process.stdout.write).mockRestore()
    stderr.mockRestore()
    writeFileSync(file('out.glb'), Buffer.concat(chunks))
    expect(areasOf(file('out.glb')).length).toBeGreaterThan(0)
    expect(told).toContain('index.html: the report')
    expect(page(file('piped'))).toContain('<title>body.glb')
  })

  test('replaces an older report, and keeps other files', async () => {
    mkdirSync(file('old'))
    writeFileSync(file('old/index.html'), 'old')
    writeFileSync(file('old/notes.txt'), 'mine')
    await run(await write('body.glb'), '-o', file('out.glb'), '--report', file('old'))
    expect(page(file('old'))).toContain('<!doctype html>')
    expect(readFileSync(file('old/notes.txt'), 'utf8')).toBe('mine')
  })

  test('the progress bar shows each step in order, and the progress within long steps', async () => {
    const start = vi.spyOn(SingleBar.prototype, 'start')
    const update = vi.spyOn(SingleBar.prototype, 'update')
    await run(await write('body.glb'), '-o', file('out.glb'), '--report', file('report'))
    const steps = ['reading', ...AUTO_STEPS, 'encoding', 'report', 'pictures', 'writing']
    expect(start.mock.calls).toEqual([[steps.length, 0, { step: 'reading' }]])
    const calls = update.mock.calls as unknown as [number, { step: string }][]
    const shown = calls.map(([value, { step }]) => ({ value, step }))
    for (const [i, step] of steps.entries()) expect(shown).toContainEqual({ value: i, step })
    expect(shown.filter(({ value }) => !Number.isInteger(value)).length).toBeGreaterThan(2)
    for (const { value, step } of shown) expect(step.split(' ')[0]).toBe(steps[Math.floor(value)])
    const values = shown.map(({ value }) => value)
    expect(values).toEqual(values.toSorted((a, b) => a - b))
  })
})

describe('unusable blendshapes', () => {
  const zeros = (shape: Sheet) => new Float32Array(shape.positions.length)

  test('stay in the file and drive nothing if they move nothing', async () => {
    const face = await write('zero.glb', (shape) => {
      shape.targets = { nothing: zeros(shape), ...shape.targets }
    })
    await run(face, '-o', file('out.glb'), '--json')
    const { areas, warnings } = JSON.parse(at.printed)
    expect(areas[0].links).toEqual([{ name: 'bend', weight: expect.any(Number) }])
    expect(warnings).toHaveLength(1)
    expect(jsonOf(readFileSync(file('out.glb'))).meshes[0].extras.targetNames).toEqual(['nothing', 'bend'])
  })

  test.each([
    ['one that goes too far', 1e6, 'moves vertices farther than 2 times the size of the face'],
    ['one with NaN', Number.NaN, 'has offsets that are NaN or infinite'],
    ['one with Infinity', Number.POSITIVE_INFINITY, 'has offsets that are NaN or infinite'],
  ])('are left out and named: %s', async (_, value, problem) => {
    const face = await write('odd.glb', (shape) => {
      const odd = zeros(shape)
      odd[100] = value
      shape.targets.odd = odd
    })
    await run(face, '-o', file('out.glb'), '--json')
    const { areas, warnings } = JSON.parse(at.printed)
    expect(areas[0].links).toEqual([{ name: 'bend', weight: expect.any(Number) }])
    expect(warnings[0]).toContain(`blendshape "odd" ${problem}`)
    expect(at.warned.split('\n')).toHaveLength(3)
  })
})

describe('partly invalid geometry', () => {
  test.each<[string, (shape: Sheet) => void]>([
    [
      'triangles without surface',
      ({ indices }) => {
        for (let i = 0; i < indices.length; i += 30) indices.fill(indices[i]!, i, i + 3)
      },
    ],
    [
      'triangles without surface in the texture',
      ({ indices, uvs }) => {
        for (let i = 0; i < 60; i++) uvs!.copyWithin(2 * indices[i]!, 2 * indices[0]!, 2 * indices[0]! + 2)
      },
    ],
    [
      'vertices of no triangle, more than of some',
      (shape) => {
        const more = (array: Float32Array<ArrayBuffer>) => {
          const out = new Float32Array(4 * array.length)
          out.set(array)
          return out
        }
        shape.positions = more(shape.positions)
        shape.uvs = more(shape.uvs!)
        shape.targets = { bend: more(shape.targets.bend!) }
      },
    ],
  ])('is skipped: %s', async (_, spoil) => {
    await run(await write('spoilt.glb', spoil), '-o', file('out.glb'))
    expect(at.warned).toMatch(/^furrow auto: no face detected .*\n$/)
    expect(areasOf(file('out.glb')).length).toBeGreaterThan(0)
  })
})

describe('input without possible wrinkles is refused in one line:', () => {
  test.each<[string, (shape: Sheet) => void, string]>([
    [
      'no blendshapes',
      (shape) => {
        shape.targets = {}
      },
      'no blendshapes',
    ],
    [
      'blendshapes that move nothing',
      ({ targets }) => {
        targets.bend!.fill(0)
      },
      'no blendshape moves the mesh',
    ],
    [
      'blendshapes that push nothing together',
      ({ targets }) => {
        targets.bend!.fill(0.1)
      },
      'no blendshape compresses the skin enough',
    ],
    [
      'no texture coordinates',
      (shape) => {
        shape.uvs = undefined
      },
      'can wrinkle',
    ],
    ['texture coordinates on one spot', ({ uvs }) => void uvs!.fill(0.5), 'span no area'],
    [
      'texture coordinates that are NaN',
      ({ uvs }) => void uvs!.fill(Number.NaN, 7, 8),
      'a texture coordinate is NaN or infinite',
    ],
    [
      'a position that is NaN',
      ({ positions }) => void positions.fill(Number.NaN, 7, 8),
      'a position is NaN or infinite',
    ],
    ['all triangles without surface', ({ indices }) => void indices.fill(3), 'furrow auto'],
    ['all vertices at one place', ({ positions }) => void positions.fill(1), 'the mesh has no area'],
    [
      'all vertices on one line',
      ({ positions }) => {
        for (let i = 0; i < positions.length; i++) if (i % 3 > 0) positions[i] = 0
      },
      'no area',
    ],
    [
      'an index out of range',
      ({ indices }) => void indices.fill(1e6, 5, 6),
      'has the index 1000000, but only 1681 vertices',
    ],
  ])('%s', async (_, spoil, message) => {
    await fails(message, await write('bad.glb', spoil), '-o', file('x.glb'), '--size', '512')
  })

  test.each<[string, (json: Json) => unknown, string]>([
    [
      'no triangles but lines',
      ({ meshes }) => Object.assign(meshes[0].primitives[0], { mode: 1 }),
      'can wrinkle',
    ],
    ['no material', ({ meshes }) => void delete meshes[0].primitives[0].material, 'can wrinkle'],
    [
      'no mesh',
      (json) => {
        json.meshes = []
        delete json.nodes[0].mesh
      },
      'can wrinkle',
    ],
    [
      'an accessor beyond its bytes',
      ({ accessors }) => Object.assign(accessors[0], { count: 1e6 }),
      'cannot read the face',
    ],
    [
      'two million triangles and one',
      ({ asset, accessors, meshes }) => {
        Object.assign(accessors[meshes[0].primitives[0].indices], { count: 6_000_003 })
        // Makes the file larger, because a small file that declares so many triangles is refused for its size.
        asset.extras = ' '.repeat(2_000_001)
      },
      'the mesh "torso" has too many triangles, got 2000001, allowed: 2,000,000',
    ],
  ])('%s', async (_, edit, message) => {
    writeFileSync(file('bad.glb'), editGlb(readFileSync(await write('body.glb')), edit))
    await fails(message, file('bad.glb'), '-o', file('x.glb'))
  })

  test('a missing mesh', async () => {
    const face = await write('body.glb')
    await fails('got "head"', face, '-o', file('x.glb'), '--mesh', 'head')
    await run(face, '-o', file('out.glb'), '--mesh', 'body')
  })
})

describe('files', () => {
  test('existing wrinkles are replaced only on request', async () => {
    const face = await write('body.glb')
    await run(face, '-o', file('once.glb'))
    await fails('the material already has wrinkles, got "cloth"', file('once.glb'), '-o', file('x.glb'))
    await run(file('once.glb'), '-o', file('twice.glb'), '--replace')
    expect(readFileSync(file('twice.glb')).equals(readFileSync(file('once.glb')))).toBe(true)
    await run(file('once.glb'), '-o', file('once.glb'), '--replace', '--force', '--seed', '2')
    expect(readFileSync(file('twice.glb')).equals(readFileSync(file('once.glb')))).toBe(false)
  })

  test('the seed in the file is used again unless another one is given', async () => {
    const seedOf = (path: string) => {
      const { extensions } = jsonOf(readFileSync(file(path))).materials[0]
      return extensions[NAME].strokes.seed
    }
    await run(await write('body.glb'), '-o', file('once.glb'), '--seed', '7')
    await run(file('once.glb'), '-o', file('again.glb'), '--replace')
    await run(file('once.glb'), '-o', file('other.glb'), '--replace', '--seed', '8')
    expect(['once.glb', 'again.glb', 'other.glb'].map(seedOf)).toEqual([7, 7, 8])
  })
})

interface Json {
  asset: { extras?: string }
  meshes: { primitives: { mode?: number; material?: number; indices: number }[] }[]
  nodes: { mesh?: number }[]
  accessors: { count: number }[]
}

/** Returns the binary chunk of a `.glb`. */
function binOf(bytes: Uint8Array): Buffer {
  const file = Buffer.from(bytes)
  const begin = 20 + file.readUInt32LE(12)
  return file.subarray(begin + 8, begin + 8 + file.readUInt32LE(begin))
}
