import { areaWeights, FurrowError } from 'furrow'
import {
  addArea,
  decodeImage,
  ExpressionPlayer,
  loadWrinkleSet,
  removeArea,
  toGray,
  Wrinkles,
} from 'furrow/three'
import { DataTexture, Mesh, MeshBasicMaterial, MeshStandardMaterial, PlaneGeometry } from 'three'
import { describe, expect, it, vi } from 'vitest'
import { randomImage, randomSet } from '../../cases.ts'
import { seeded } from '../../random.ts'
import { grayPng, png } from '../images.ts'

describe('images', () => {
  it('have exact 8-bit values', async () => {
    const values = Uint8Array.from({ length: 256 }, (_, i) => i)
    expect([...toGray(await decodeImage(await png(256, 1, 8, 0, values), 'ramp')).data]).toEqual([...values])
  })

  it('have 16-bit values within one step of 8 bits', async () => {
    const raw = new Uint8Array(512)
    for (let i = 0; i < 256; i++) new DataView(raw.buffer).setUint16(i * 2, i * 257)
    const image = toGray(await decodeImage(await png(256, 1, 16, 0, raw), 'ramp'))
    for (let i = 0; i < 256; i++) expect(Math.abs(image.data[i] - i)).toBeLessThanOrEqual(1)
  })

  it.each<[string, () => Promise<Blob>, RegExp]>([
    [
      'empty',
      async () => new Blob([]),
      /^area.png: empty image file, got "0 bytes"; export the image again$/,
    ],
    [
      'not an image',
      async () => new Blob(['<html>404</html>']),
      /^area.png: not a readable image, got "16 bytes", allowed: an intact PNG, JPEG, WebP or AVIF file; export/,
    ],
    [
      'transparent',
      async () => png(2, 2, 8, 6, Uint8Array.of(9, 9, 9, 255, 9, 9, 9, 254, 9, 9, 9, 255, 9, 9, 9, 255)),
      /^area.png: image with transparent texels, got "alpha 254", allowed: alpha 255 in all texels; flatten the image onto white/,
    ],
    [
      '16k',
      () => grayPng(16384, 4, 0),
      /^area.png: image too large, got "16384 x 4", allowed: at most 8192 texels per side; scale the image down/,
    ],
  ])('are refused: %s', async (_, make, message) => {
    const error = await decodeImage(await make(), 'area.png').catch((caught) => caught)
    expect(error).toBeInstanceOf(FurrowError)
    expect(error.message).toMatch(message)
  })

  it('are refused if truncated at any byte', async () => {
    const intact = await png(
      64,
      64,
      8,
      0,
      Uint8Array.from({ length: 4096 }, seeded(1)).map((_, i) => (i * 97) % 256),
    )
    for (let fraction = 0.05; fraction < 1; fraction += 0.1) {
      const cut = intact.slice(0, Math.floor(intact.size * fraction))
      await expect(decodeImage(cut, 'area.png'), `${fraction}`).rejects.toThrow(
        /^area.png: (not a readable image|empty)/,
      )
    }
  })

  it('are refused as areas of a single texel', async () => {
    const image = toGray(await decodeImage(await grayPng(1, 1, 0), 'dot.png'))
    expect(() => areaWeights(image, 'paper', 'dot.png')).toThrow(
      /^dot.png: area image too small, got "1 x 1"/,
    )
  })
})

describe('loadWrinkleSet', () => {
  it("reads a set with its drivers and maps from a folder's default paths", async () => {
    const layer = {
      name: 'a#b',
      normalScale: 0.5,
      baseColor: 'c.png',
      roughness: 'r.png',
      occlusion: 'o.png',
    }
    const driver = { type: 'morph', area: 'nose', targets: [{ name: 'noseSneerLeft', weight: 1 }] }
    const text = JSON.stringify({
      layers: [{ ...layer, occlusionStrength: 0.25 }],
      areas: [{ name: 'nose' }, { name: 'brow', image: 'b.png', convention: 'weight', activation: 0.5 }],
      drivers: [driver],
    })
    const files: Record<string, Blob> = {
      'wrinkles.json': new Blob([text]),
      'layers/a%23b/normal.png': await grayPng(4, 4, 10),
      'c.png': await grayPng(4, 4, 20),
      'r.png': await grayPng(4, 4, 30),
      'o.png': await grayPng(4, 4, 40),
      'areas/nose.png': await grayPng(2, 2, 50),
      'b.png': await grayPng(2, 2, 60),
    }
    const asked: string[] = []
    vi.stubGlobal('fetch', async (address: URL) => {
      const [, path] = address.pathname.split('/my-face/')
      asked.push(path)
      return new Response(files[path])
    })
    const set = await loadWrinkleSet('my-face/wrinkles.json').finally(() => vi.unstubAllGlobals())
    expect(asked.sort()).toEqual(Object.keys(files).sort())
    const [{ normal, baseColor, roughness, occlusion, ...rest }] = set.layers
    const first = [normal, baseColor, roughness, occlusion].map(
      (map) => (map as { data: Uint8Array }).data[0],
    )
    expect(first).toEqual([10, 20, 30, 40])
    expect(rest).toEqual({ name: 'a#b', kind: 'replace', normalScale: 0.5, occlusionStrength: 0.25 })
    expect(set.areas.map(({ name, weights: { data }, activation }) => [name, data[0], activation])).toEqual([
      ['nose', 205, undefined],
      ['brow', 60, 0.5],
    ])
    expect(set.drivers).toMatchObject([driver])
    const mesh = new Mesh(new PlaneGeometry(), new MeshStandardMaterial())
    mesh.morphTargetDictionary = { noseSneerLeft: 0 }
    mesh.morphTargetInfluences = [0.75]
    const wrinkles = new Wrinkles(mesh, set)
    wrinkles.update()
    expect(wrinkles.getActivation('nose')).toBe(0.75)
    wrinkles.dispose()
  })

  it.each<[string, unknown, RegExp]>([
    [
      'a missing file',
      undefined,
      /not-there\/wrinkles.json: (file not found, got "HTTP status 404"|not JSON)/,
    ],
    ['text that is not JSON', '{"version":', /not JSON, got ".*"; check the address and the file/],
    [
      'JSON of the wrong shape',
      { version: 1, layers: [] },
      /layers has the wrong number of items, got 0, allowed: 1 to 4 items/,
    ],
    [
      'no areas',
      { version: 1, layers: [{ name: 'a', normal: 'a.png' }] },
      /areas must be an array, got nothing/,
    ],
  ])('refuses %s', async (_, content, message) => {
    const url = content === undefined ? '/not-there/wrinkles.json' : URL.createObjectURL(asFile(content))
    await expect(loadWrinkleSet(url)).rejects.toThrow(message)
  })
})

describe('meshes', () => {
  const set = randomSet(seeded(1), 2, 8)
  const mesh = () => new Mesh(new PlaneGeometry(), new MeshStandardMaterial())

  it.each(['uv', 'normal', 'position'])('are refused without %s, and keep their material', (attribute) => {
    const bare = mesh()
    bare.name = 'head'
    bare.geometry.deleteAttribute(attribute)
    const before = JSON.stringify(bare.material.toJSON())
    expect(() => new Wrinkles(bare, set)).toThrow(
      new RegExp(
        `^Wrinkles: mesh without ${attribute}, got "head", allowed: a mesh with positions, normals and UVs; `,
      ),
    )
    expect(JSON.stringify(bare.material.toJSON())).toBe(before)
  })

  it('are refused with an unlit material', () => {
    const unlit = new Mesh(new PlaneGeometry(), new MeshBasicMaterial())
    expect(() => new Wrinkles(unlit, set)).toThrow(/material MeshBasicMaterial does not support normal maps/)
  })

  it('are refused with several unlit materials', () => {
    const several = new Mesh(new PlaneGeometry(), [new MeshBasicMaterial(), new MeshBasicMaterial()])
    expect(() => new Wrinkles(several as unknown as Mesh, set)).toThrow(
      /material MeshBasicMaterial does not support normal maps.*use a lit material/,
    )
  })

  it('are refused without targets for an expression', () => {
    const bare = mesh()
    bare.name = 'statue'
    expect(() => new ExpressionPlayer(bare, new Wrinkles(bare, set))).toThrow(
      'ExpressionPlayer: no morph targets, got "statue", allowed: at least one mesh with named blendshapes; export',
    )
  })
})

describe('wrinkles', () => {
  it("refuse the paper's mode for maps of unequal size, and keep the previous mode", () => {
    const set = randomSet(seeded(1), 2, 8, 16)
    const mesh = new Mesh(new PlaneGeometry(), new MeshStandardMaterial())
    mesh.material.map = new DataTexture(randomImage(seeded(2), 32).data, 32, 32)
    const wrinkles = new Wrinkles(mesh, set)
    expect(() => {
      wrinkles.mode = 'paper'
    }).toThrow(/^Wrinkles.mode paper: image 1 differs in size from image 0, got "16 x 16", allowed: 32 x 32/)
    expect(wrinkles.mode).toBe('default')
  })

  it('stay unchanged if an area cannot be added or removed', () => {
    const set = randomSet(seeded(1), 1, 8)
    const mesh = new Mesh(new PlaneGeometry(), new MeshStandardMaterial())
    const wrinkles = new Wrinkles(mesh, set)
    const [area] = set.areas
    expect(() => addArea(wrinkles, area)).toThrow(/^addArea: two areas with the same name, got "area0"/)
    expect(() => addArea(wrinkles, { ...area, name: 'b', layer: 'skim' })).toThrow(
      /unknown layer, got "skim"/,
    )
    expect(() => removeArea(wrinkles, 'b')).toThrow(/unknown area, got "b", allowed: "area0"/)
    expect(() => removeArea(wrinkles, 'area0')).toThrow(
      /^removeArea: no areas, got 0, allowed: 1 to 256 areas/,
    )
    expect(wrinkles.areaNames).toEqual(['area0'])
  })

  it('play expressions with missing names, and list those names in one warning', () => {
    const warn = vi.spyOn(console, 'warn').mockImplementation(() => {})
    const mesh = new Mesh(new PlaneGeometry(), new MeshStandardMaterial())
    mesh.morphTargetDictionary = { jawOpen: 0 }
    mesh.morphTargetInfluences = [0]
    const player = new ExpressionPlayer(mesh, new Wrinkles(mesh, randomSet(seeded(1), 1, 8)), [
      { name: 'neutral', targets: {}, activations: {} },
      { name: 'shout', targets: { jawOpen: 1, jawDrop: 1 }, activations: { throat: 1 } },
    ])
    player.play('shout', 0)
    expect(mesh.morphTargetInfluences).toEqual([1])
    expect(warn.mock.calls.map(([text]) => text)).toEqual([
      'ExpressionPlayer: the face lacks blendshapes or areas of the expressions, got "jawDrop, throat"; expressions play without them',
    ])
    warn.mockRestore()
  })
})

function asFile(content: unknown): Blob {
  return new Blob([typeof content === 'string' ? content : JSON.stringify(content)])
}
