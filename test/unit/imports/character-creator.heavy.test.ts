import { beforeAll, describe, expect, it } from 'vitest'
import { CHARACTER_SHAPES, CharacterSource } from '../../imports/character-source.ts'
import { colourSteps, Evaluated, normalSteps, type Pose, someTexels } from '../../imports/evaluate.ts'
import { normalPng, rgbPng } from '../../imports/paint.ts'
import { type PlaneLooks, planeFace } from '../../imports/plane-face.ts'
import { bench, wrinklesIn } from '../cli/workshop.ts'

const tool = bench('import')
const SIZE = 128
const texels = someTexels(SIZE, 2500)

/** Weights of left and right halves of blendshapes. */
const both = (name: string, weight = 1): Pose => ({ [`${name}_L`]: weight, [`${name}_R`]: weight })

/** Expressions in which no two sets crease the same skin, so that the formulas of the source and of Furrow agree. */
const POSES: readonly Pose[] = [
  {},
  both('Brow_Raise_Inner'),
  both('Brow_Raise_Inner', 0.5),
  { ...both('Brow_Raise_Inner', 0.7), ...both('Brow_Raise_Outer') },
  { Brow_Raise_Inner_L: 1, Brow_Raise_Outer_L: 0.6 },
  { Brow_Raise_Outer_R: 0.3 },
  both('Brow_Drop'),
  both('Brow_Drop', 0.4),
  { Brow_Drop_L: 0.8, Nose_Sneer_L: 0.2 },
  both('Nose_Sneer', 0.9),
  both('Eye_Blink'),
  { Eye_Blink_L: 0.6 },
  both('Cheek_Raise', 0.5),
  both('Mouth_Smile'),
  both('Mouth_Smile', 0.35),
  { Mouth_Smile_L: 0.9, Cheek_Raise_L: 0.4 },
  { ...both('Mouth_Stretch', 0.7), Jaw_Open: 0.5 },
  { Jaw_Open: 1, ...both('Eye_Blink', 0.2) },
  { ...both('Mouth_Pucker_Up', 0.8), Mouth_Chin_Up: 0.5 },
  {
    ...both('Brow_Raise_Inner', 0.9),
    ...both('Brow_Raise_Outer', 0.9),
    ...both('Mouth_Smile', 0.6),
    Jaw_Open: 0.3,
  },
]

async function importCharacter(
  name: string,
  source: CharacterSource,
  looks: PlaneLooks = {},
  ...options: string[]
) {
  for (const [path, bytes] of Object.entries(await source.files())) tool.shop.write(`${name}/${path}`, bytes)
  const face = await planeFace(CHARACTER_SHAPES, {
    normalMap: await normalPng(source.base),
    baseColour: await rgbPng(SIZE, source.diffuse()),
    mesh: 'CC_Base_Body',
    material: 'Std_Skin_Head.001',
    ...looks,
  })
  tool.shop.write(`${name}.glb`, face)
  const output = tool.file(`${name}-out.glb`)
  await tool.run(tool.file(name), '--face', tool.file(`${name}.glb`), '-o', output, ...options)
  return Evaluated.of(output)
}

function largestSteps(shown: Evaluated, source: CharacterSource, power = 1) {
  const steps = POSES.map((pose) => {
    const [own, theirs] = [shown.shade(pose, texels), source.shade(pose, power, texels)]
    return {
      normals: normalSteps(own.normals, theirs.normals),
      colours: colourSteps(own.colours, theirs.colours),
    }
  })
  return {
    normals: Math.max(...steps.map(({ normals }) => normals)),
    colours: Math.max(...steps.map(({ colours }) => colours)),
  }
}

describe('furrow import of Character Creator', () => {
  const source = new CharacterSource({ size: SIZE })
  let shown: Evaluated
  beforeAll(async () => {
    shown = await importCharacter('Kevin', source)
  })

  it('shows 20 poses as the source within 2 of 255', () => {
    const { normals, colours } = largestSteps(shown, source)
    expect(normals).toBeLessThanOrEqual(2)
    expect(colours).toBeLessThanOrEqual(2)
    expect(
      normalSteps(shown.shade({}, texels).normals, source.shade(both('Mouth_Smile')).normals),
    ).toBeGreaterThan(20)
  })

  it('makes a layer per set and an area per rule and side', () => {
    const { layers, areas } = wrinklesIn(tool.file('Kevin-out.glb'))
    expect(layers.map(({ name }: { name: string }) => name)).toEqual([
      'wrinkles 1',
      'wrinkles 2',
      'wrinkles 3',
    ])
    expect(areas).toHaveLength(49)
    expect(tool.warned).toBe('')
  })

  it('gives raised brows that are drawn together their own creases', () => {
    const pose = { Brow_Raise_Inner_L: 0.8, Brow_Drop_L: 0.5 }
    const values = source.values(pose)
    const activations = shown.activations(pose)
    for (const [area, key] of [
      ['browRaiseInner_L', '1 browRaiseInner L'],
      ['browsLateral_L', '2 browsLateral L'],
      ['browRaiseCorrection_L', '3 browRaiseCorrection L'],
    ] as const) {
      expect(activations.get(area), area).toBeCloseTo(values.get(key)!, 5)
    }
    expect(activations.get('browRaiseCorrection_L')).toBeGreaterThan(0.4)
  })
})

it.each([
  ['everywhere', [0.4, 0.4]],
  ['from late to early wrinkles', [0.2, 1]],
] as const)('flow %s becomes onset within 2 of 255', async (name, flow) => {
  const source = new CharacterSource({ size: SIZE, flow })
  const shown = await importCharacter(`flow-${name.length}`, source)
  const { normals, colours } = largestSteps(shown, source)
  expect(normals).toBeLessThanOrEqual(2)
  expect(colours).toBeLessThanOrEqual(2)
})

it('two sets that crease the same skin add up to 1, where the source takes the larger', async () => {
  const source = new CharacterSource({ size: SIZE })
  const shown = await importCharacter('overlap', source)
  const pose = { ...both('Brow_Raise_Inner'), ...both('Brow_Drop', 0.5) }
  const steps = normalSteps(shown.shade(pose, texels).normals, source.shade(pose, 1, texels).normals)
  expect(steps).toBeGreaterThan(2)
  expect(steps).toBeLessThan(20)
})

it('powers, weights and the overall weight shape the drivers', async () => {
  const weights = { head_wm3_normal_head_wm3_smile_L: 0.5 }
  const source = new CharacterSource({ size: SIZE, weights, overall: 0.8 })
  const shown = await importCharacter('shaped', source, {}, '--power', 'all=1.7')
  for (const pose of POSES) {
    const values = source.values(pose, 1.7)
    const activations = shown.activations(pose)
    expect(activations.get('smile_L')).toBeCloseTo(values.get('3 smile L')!, 2)
    expect(activations.get('jawOpen')).toBeCloseTo(values.get('1 jawOpen L')!, 2)
  }
  expect(source.values(both('Mouth_Smile', 0.5), 1.7).get('3 smile L')).toBeLessThan(0.1)
})

it("reads the regions' powers from Blender's custom properties", async () => {
  const curves = Array(13).fill(1)
  curves[11] = 0.5
  const shown = await importCharacter('blender', new CharacterSource({ size: SIZE }), {
    extras: { wrinkle_curves: curves, wrinkle_strength: 1 },
  })
  expect(shown.activations({ Jaw_Open: 0.25 }).get('jawOpen')).toBeCloseTo(0.5, 2)
  expect(shown.activations({ Mouth_Chin_Up: 0.25 }).get('chinRaise_L')).toBeCloseTo(0.25, 2)
})
