import { expect, it } from 'vitest'
import { CHARACTER_SHAPES, CharacterSource } from '../../imports/character-source.ts'
import { lit, type Shaded, writeSheet } from '../../imports/contact-sheet.ts'
import { Evaluated, type Pose } from '../../imports/evaluate.ts'
import { CREASES, ExpressionSourceFiles } from '../../imports/expression-source.ts'
import { METAHUMAN_SHAPES, MetahumanSource } from '../../imports/metahuman-source.ts'
import { normalPng, rgbPng } from '../../imports/paint.ts'
import { type PlaneLooks, planeFace } from '../../imports/plane-face.ts'
import { bench } from '../cli/workshop.ts'

/** With this variable, the tests write the pictures of the documentation into a folder. */
const { FURROW_IMPORT_SHEETS: FOLDER } = process.env
const SIZE = 256
const ALL = [...Array(SIZE * SIZE).keys()]

const tool = bench('import')

const both = (left: string, right: string, weight = 1): Pose => ({ [left]: weight, [right]: weight })
const sides = (name: string, weight = 1) => both(`${name}L`, `${name}R`, weight)

/** Imports files into a face and returns the largest difference of lit pixels. */
async function compare(
  name: string,
  files: Record<string, Uint8Array>,
  targets: readonly string[],
  looks: PlaneLooks,
  poses: readonly Pose[],
  shade: (pose: Pose) => Shaded,
): Promise<number> {
  for (const [path, bytes] of Object.entries(files)) tool.shop.write(`${name}/${path}`, bytes)
  tool.shop.write(`${name}.glb`, await planeFace(targets, looks))
  await tool.run(tool.file(name), '--face', tool.file(`${name}.glb`), '-o', tool.file(`${name}-out.glb`))
  const evaluated = await Evaluated.of(tool.file(`${name}-out.glb`))
  const pairs = poses.map((pose) => {
    const source = shade(pose)
    const { normals, colours } = evaluated.shade(pose)
    return { source, shown: { normals, ...(source.colours && { colours }) } }
  })
  await writeSheet(FOLDER, name, SIZE, pairs)
  const differences = pairs.map(({ source, shown }) => {
    const [theirs, own] = [lit(source), lit(shown)]
    return theirs.reduce((most, byte, i) => Math.max(most, Math.abs(byte - own[i]!)), 0)
  })
  return Math.max(...differences)
}

it('lit skin looks as with the formula of expression maps', async () => {
  const source = new ExpressionSourceFiles(SIZE)
  const poses: Pose[] = [
    {},
    { surprise: 1 },
    { surprise: 0.5 },
    { anger: 1 },
    both('smileLeft', 'smileRight'),
    { smileLeft: 1, anger: 0.6 },
  ]
  const looks = { normalMap: await normalPng(source.neutral) }
  const shade = (pose: Pose) => ({ normals: source.shade(pose) })
  expect(
    await compare('expressions', await source.files(), Object.keys(CREASES), looks, poses, shade),
  ).toBeLessThan(4)
})

it("lit skin looks as with the formula of Character Creator's add-ons", async () => {
  const source = new CharacterSource({ size: SIZE, flow: [0.2, 1] })
  const poses: Pose[] = [
    {},
    sides('Brow_Raise_Inner_'),
    sides('Brow_Drop_'),
    sides('Mouth_Smile_'),
    sides('Mouth_Smile_', 0.5),
    { ...sides('Nose_Sneer_'), Jaw_Open: 1 },
  ]
  const looks = {
    normalMap: await normalPng(source.base),
    baseColour: await rgbPng(SIZE, source.diffuse()),
    material: 'Std_Skin_Head',
  }
  const shade = (pose: Pose) => source.shade(pose)
  expect(
    await compare('character-creator', await source.files(), CHARACTER_SHAPES, looks, poses, shade),
  ).toBeLessThan(10)
})

it("lit skin looks as with the formula of MetaHuman's head shader", async () => {
  const source = new MetahumanSource(SIZE)
  const poses: Pose[] = [
    {},
    { ...sides('browRaiseIn'), ...sides('browRaiseOuter') },
    { ...sides('browDown'), ...sides('browLateral') },
    sides('mouthCornerPull'),
    sides('mouthCornerPull', 0.5),
    { ...sides('noseWrinkle'), ...sides('mouthStretch', 0.8) },
  ]
  const looks = { normalMap: await normalPng(source.base), baseColour: await rgbPng(SIZE, source.colours(0)) }
  const shade = (pose: Pose) => source.shade(pose, ALL)
  expect(
    await compare('metahuman', await source.files(), METAHUMAN_SHAPES, looks, poses, shade),
  ).toBeLessThan(4)
})
