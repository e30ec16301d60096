import { beforeAll, describe, expect, it } from 'vitest'
import { colourSteps, Evaluated, normalSteps, type Pose, someTexels } from '../../imports/evaluate.ts'
import { METAHUMAN_SHAPES, MetahumanSource } from '../../imports/metahuman-source.ts'
import { normalPng, rgbPng } from '../../imports/paint.ts'
import { planeFace } from '../../imports/plane-face.ts'
import { bench } from '../cli/workshop.ts'

const tool = bench('import')
const SIZE = 128
const source = new MetahumanSource(SIZE)
const texels = someTexels(SIZE, 2500)

const both = (name: string, weight = 1): Pose => ({ [`${name}L`]: weight, [`${name}R`]: weight })

const POSES: readonly Pose[] = [
  {},
  both('browRaiseIn'),
  both('browRaiseIn', 0.5),
  { ...both('browRaiseIn', 0.7), ...both('browRaiseOuter') },
  { browRaiseInL: 1, browRaiseOuterL: 0.6 },
  { browRaiseOuterR: 0.3 },
  both('browDown'),
  { ...both('browDown', 0.4), ...both('browLateral', 0.8) },
  { browDownL: 0.8, noseWrinkleL: 0.2 },
  both('noseWrinkle', 0.9),
  both('eyeBlink'),
  { eyeBlinkL: 0.6 },
  both('mouthCornerPull'),
  both('mouthCornerPull', 0.35),
  { mouthCornerPullL: 0.9, eyeBlinkL: 0.4 },
  both('mouthStretch', 0.7),
  { mouthStretchL: 1, browLateralR: 0.5 },
  { ...both('browLateral'), ...both('mouthCornerPull', 0.2) },
  { ...both('noseWrinkle', 0.5), ...both('browDown', 0.5), ...both('eyeBlink', 0.5) },
  {
    ...both('browRaiseIn', 0.9),
    ...both('browRaiseOuter', 0.9),
    ...both('mouthCornerPull', 0.6),
    ...both('eyeBlink', 0.1),
  },
]

async function face(name: string, targets: readonly string[]): Promise<string> {
  const looks = { normalMap: await normalPng(source.base), baseColour: await rgbPng(SIZE, source.colours(0)) }
  return tool.shop.write(`${name}.glb`, await planeFace(targets, looks))
}

async function importInto(name: string, targets: readonly string[]): Promise<Evaluated> {
  await tool.run(tool.file('export'), '--face', await face(name, targets), '-o', tool.file(`${name}-out.glb`))
  return Evaluated.of(tool.file(`${name}-out.glb`))
}

beforeAll(async () => {
  for (const [path, bytes] of Object.entries(await source.files())) tool.shop.write(`export/${path}`, bytes)
})

describe('furrow import of a MetaHuman', () => {
  it('shows 20 poses as the source within 2 of 255', async () => {
    const shown = await importInto('own', METAHUMAN_SHAPES)
    for (const pose of POSES) {
      const [own, theirs] = [shown.shade(pose, texels), source.shade(pose, texels)]
      expect(normalSteps(own.normals, theirs.normals), JSON.stringify(pose)).toBeLessThanOrEqual(2)
      expect(colourSteps(own.colours, theirs.colours), JSON.stringify(pose)).toBeLessThanOrEqual(2)
    }
    const smile = source.shade(both('mouthCornerPull'), texels)
    expect(normalSteps(shown.shade({}, texels).normals, smile.normals)).toBeGreaterThan(20)
  })

  it('makes a layer per animated map and an area per curve, and lists other files', async () => {
    await tool.run(
      tool.file('export'),
      '--face',
      tool.file('own.glb'),
      '-o',
      tool.file('listed.glb'),
      '--json',
    )
    const { source: kind, layers, areas, unread, lost } = JSON.parse(tool.printed)
    expect(kind).toBe('metahuman')
    expect(layers).toEqual(['wrinkles 1', 'wrinkles 2', 'wrinkles 3'])
    expect(areas).toHaveLength(41)
    expect(new Set(areas).size).toBe(41)
    expect(unread).toEqual(['ExportManifest.json', 'head.dna'])
    expect(lost).toEqual([])
  })
})

it.each([
  [
    'names of the DNA file',
    ['head_lod0_mesh__brow_raiseIn_L', 'head_lod0_mesh__jaw_open'],
    'head_lod0_mesh__brow_raiseIn_L',
  ],
  ['names of curves', ['CTRL_expressions_browRaiseInL'], 'CTRL_expressions_browRaiseInL'],
  ['ARKit', ['browInnerUp', 'browDownLeft'], 'browInnerUp'],
])('blendshapes with the %s drive the brows', async (_, targets, name) => {
  const shown = await importInto(`named-${targets.length}-${name.length}`, targets)
  expect(shown.activations({ [name]: 0.6 }).get('browsRaiseInner_L')).toBeCloseTo(0.6)
})

it('without blendshapes, the page sets inputs with the names of the rig curves', async () => {
  const shown = await importInto('inputs', ['other'])
  expect(tool.printed).toContain('lost: the face has no known blendshape')
  const activations = shown.activations({ head_wm3_normal_head_wm13_lips_DL: 0.4 })
  expect(activations.get('lipsSmile_DL')).toBeCloseTo(0.4)
  expect(activations.get('lipsPurse_DL')).toBe(0)
})

it('maps around mid gray are added to the skin', async () => {
  const gray = await rgbPng(SIZE, new Uint8Array(3 * SIZE ** 2).fill(128))
  const flat = await rgbPng(
    SIZE,
    Uint8Array.from({ length: 3 * SIZE ** 2 }, (_, i) => (i % 3 === 2 ? 255 : 128)),
  )
  for (const [path, bytes] of Object.entries(await source.files())) {
    const isNormal = path.includes('_Normal_')
    tool.shop.write(`delta/${path}`, isNormal ? flat : path.includes('_Basecolor_') ? gray : bytes)
  }
  await tool.run(tool.file('delta'), '--face', tool.file('own.glb'), '-o', tool.file('delta.glb'))
  expect(tool.printed).toContain('taken as an overlay')
  const shown = await Evaluated.of(tool.file('delta.glb'))
  const [still, moved] = [shown.shade({}, texels), shown.shade(both('browRaiseIn'), texels)]
  expect(normalSteps(still.normals, moved.normals)).toBeLessThanOrEqual(1)
  expect(colourSteps(still.colours, moved.colours)).toBeLessThanOrEqual(1)
})

describe('furrow import refuses a MetaHuman', () => {
  it('without a mask, and names the remedy', async () => {
    for (const [path, bytes] of Object.entries(await source.files())) {
      if (!path.includes('wm2_msk_02')) tool.shop.write(`bare/${path}`, bytes)
    }
    const message = /the mask head_wm2_msk_02 is missing.*DCC export, which has them in Masks/
    await tool.fails(message, tool.file('bare'), '--face', tool.file('own.glb'), '-o', tool.file('no.glb'))
  })

  it('with a damaged mask', async () => {
    for (const [path, bytes] of Object.entries(await source.files())) {
      tool.shop.write(`torn/${path}`, path.endsWith('_01.tga') ? bytes.subarray(0, 12) : bytes)
    }
    await tool.fails(
      /msk_01.tga/,
      tool.file('torn'),
      '--face',
      tool.file('own.glb'),
      '-o',
      tool.file('no.glb'),
    )
  })
})
