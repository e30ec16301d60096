import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { afterAll, beforeAll, describe, expect, test } from 'vitest'
import type { PictureRequest } from '../../packages/cli/src/render/picture.ts'
import type { Picture } from '../../packages/cli/src/render/render-pictures.ts'
import { editGlb } from '../glb.ts'
import { addMToon, asVrm0, asVrm1 } from '../vrm.ts'
import { renderPictures } from './run-furrow.ts'

const FACE = fileURLToPath(new URL('../fixtures/files-2026-11/drawn.glb', import.meta.url))

const SIZE = { width: 96, height: 96, relief: 'off' } as const

/** Colours set in VRM materials, which only three-vrm reads. */
const GREEN = [0, 1, 0, 1]

const AVATARS: Record<string, (glb: Uint8Array) => Uint8Array> = {
  'a VRM 0 with MToon': (glb) => asVrm0(glb, 'VRM/MToon', paint),
  'a VRM 0 with VRM/UnlitTexture': (glb) => asVrm0(glb, 'VRM/UnlitTexture', paint),
  'a VRM 1.0 with MToon': (glb) =>
    asVrm1(glb, (json) => {
      addMToon(json)
      const rim = { parametricRimColorFactor: GREEN.slice(0, 3), parametricRimLiftFactor: 1 }
      for (const { pbrMetallicRoughness, extensions } of json.materials) {
        pbrMetallicRoughness.baseColorFactor = [0.2, 0.2, 0.2, 1]
        Object.assign(extensions.VRMC_materials_mtoon, { shadeColorFactor: [0.2, 0.2, 0.2], ...rim })
      }
    }),
}

// biome-ignore lint/suspicious/noExplicitAny: the JSON of a file
function paint(json: any): void {
  for (const { vectorProperties } of json.extensions.VRM.materialProperties) {
    Object.assign(vectorProperties, { _Color: GREEN, _ShadeColor: GREEN })
  }
}

describe.each(['webgl', 'webgpu'] as const)('furrow render on %s', (renderer) => {
  let folder: string
  const drawn = new Map<string, Picture>()

  beforeAll(async () => {
    folder = await mkdtemp(join(tmpdir(), 'furrow-vrm-'))
    const glb = await readFile(FACE)
    const requests: [string, PictureRequest][] = []
    for (const [kind, make] of Object.entries(AVATARS)) {
      const input = join(folder, `${requests.length}.vrm`)
      await writeFile(input, make(glb))
      const activations = Object.fromEntries(areasOf(glb).map((name) => [name, 1]))
      requests.push([kind, { input, renderer, activations, ...SIZE }])
      requests.push([`${kind} off`, { input, renderer, activations, mode: 'off', ...SIZE }])
    }
    const pictures = await renderPictures(requests.map(([, request]) => request))
    for (const [i, [name]] of requests.entries()) drawn.set(name, pictures[i])
  })

  afterAll(() => rm(folder, { recursive: true, force: true }))

  test.each(Object.keys(AVATARS))('draws %s as three-vrm does, with wrinkles', (kind) => {
    const [wrinkled, plain] = [drawn.get(kind)!, drawn.get(`${kind} off`)!]
    expect([...wrinkled.warnings, ...plain.warnings]).toEqual([])
    expect(greenPixels(plain)).toBeGreaterThan(1000)
    expect(changedPixels(wrinkled, plain)).toBeGreaterThan(20)
  })
})

test('furrow render draws a VRM that three-vrm refuses as a glTF file, with a warning', async () => {
  const folder = await mkdtemp(join(tmpdir(), 'furrow-vrm-'))
  try {
    const input = join(folder, 'broken.vrm')
    const broken = editGlb(await readFile(FACE), (json) => {
      json.extensionsUsed.push('VRMC_vrm')
      json.extensions = { VRMC_vrm: { specVersion: '1.0', meta: {}, humanoid: { humanBones: { hips: {} } } } }
    })
    await writeFile(input, broken)
    const [{ warnings }] = await renderPictures([{ input, ...SIZE }])
    expect(warnings).toEqual([
      expect.stringMatching(/broken\.vrm is drawn as plain glTF, without VRM features \(.+\)$/),
    ])
  } finally {
    await rm(folder, { recursive: true, force: true })
  }
})

function areasOf(glb: Uint8Array): string[] {
  const names: string[] = []
  editGlb(glb, ({ materials: [skin] }) => {
    for (const { name } of skin.extensions.FURROW_wrinkle_maps.areas) names.push(name)
  })
  return names
}

function greenPixels({ pixels }: Picture): number {
  let count = 0
  for (let i = 0; i < pixels.length; i += 4) {
    if (pixels[i + 1] > 1.15 * Math.max(pixels[i], pixels[i + 2])) count++
  }
  return count
}

/** Counts the pixels that differ in any bit. */
function changedPixels({ pixels }: Picture, { pixels: others }: Picture): number {
  let count = 0
  for (let i = 0; i < pixels.length; i += 4) if (pixels[i] !== others[i]) count++
  return count
}
