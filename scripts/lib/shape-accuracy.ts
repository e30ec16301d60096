import { readdirSync } from 'node:fs'
import { basename, join } from 'node:path'
import type { Skin } from 'furrow/author'
import { canonicalTargetName } from 'furrow/internal'
import { findSkin } from 'furrow-files'
import { readDocument } from 'furrow-files/node'
import { labelOf } from '../../packages/furrow/src/author/shapes/families.ts'
import { SURE } from '../../packages/furrow/src/author/shapes/matching/confidence.ts'
import { type RecognisedShape, recogniseShapes } from '../../packages/furrow/src/author/shapes/recognise.ts'
import { templateHeads } from '../../packages/furrow/src/author/shapes/templates/template-table.ts'
import type { TemplateHead } from '../../packages/furrow/src/author/shapes/templates/templates.ts'
import { seeded } from '../../test/random.ts'
import { unlabelledShapes } from '../../test/unlabelled-shapes.ts'
import { TEMPLATE_FACES } from './shape-templates.ts'

/** ARKit shapes that affect wrinkles most. */
const KEY_SHAPES =
  /^(brow(Down|OuterUp|InnerUp)|eye(Blink|Squint)|cheek(Squint|Puff)|noseSneer|mouth(Smile|Frown|Pucker)|jawOpen)/

/** Numbers of blendshapes in random subsets. */
const SUBSET_SIZES = [5, 10, 20, 30]
/** Name of the set that contains all ARKit shapes, and shapes that ARKit lacks. */
const MIXED = 'full, with sliders and composites'

/** Numbers of blendshapes by result. */
interface Counts {
  /** Blendshapes that ARKit has. Each is also counted as `right`, `unknown` or `wrong`. */
  all: number
  right: number
  unknown: number
  /** Includes shapes that ARKit lacks, if they got an ARKit name. */
  wrong: number
  /** Blendshapes in `KEY_SHAPES`. */
  key: number
  keyRight: number
  /** Recognised with a confidence above `SURE`. */
  sure: number
  sureWrong: number
}

interface Row {
  head: string
  templates: string
  /** Number of blendshapes in a random subset, or the name of a complete set. */
  set: number | 'full' | typeof MIXED
  counts: Counts
}

/**
 * Measures how many blendshapes of heads are recognised if their names are removed. Yields rows of a table, for all
 * blendshapes and for random subsets.
 *
 * @param folder heads written by faces/sample_heads.py.
 * @param seeds first and last seed of the heads to read.
 */
export async function* accuracyOf(folder: string, seeds: readonly [first: number, last: number]) {
  const [builder, scan] = templateHeads()
  const [human, human2] = TEMPLATE_FACES.builder
  const held = [
    ['scan', TEMPLATE_FACES.scan[0], 'builder only', [builder]],
    ['human', human, 'scan only', [scan]],
    ['human-2', human2, 'scan only', [scan]],
  ] as const
  for (const [head, path, templates, heads] of held) yield* rowsOf(head, [path], templates, heads)
  for (const family of ['realistic', 'stylised']) {
    const paths = readdirSync(folder)
      .map((file) => [file, Number(new RegExp(`^${family}-(\\d+)\\.glb$`).exec(file)?.[1])] as const)
      .filter(([, seed]) => seed >= seeds[0] && seed <= seeds[1])
      .sort(([, a], [, b]) => a - b)
      .map(([file]) => join(folder, file))
    yield* rowsOf(`${family} heads, seeds ${seeds.join(' to ')}`, paths, 'table', templateHeads())
  }
}

async function* rowsOf(
  head: string,
  paths: readonly string[],
  templates: string,
  heads: readonly TemplateHead[],
): AsyncGenerator<Row> {
  const sets = (['full', MIXED, ...SUBSET_SIZES] as const).map((set) => ({ set, counts: noCounts() }))
  for (const path of paths) {
    const { skin } = findSkin(await readDocument(path, 'accuracy'), path, 'accuracy')
    const random = seeded(hashOf(basename(path)))
    const moving = [...skin.targets.keys()].filter((i) => isMoving(skin, i))
    for (const { set, counts } of sets) {
      const isSubset = typeof set === 'number'
      const chosen = isSubset ? shuffled(moving, random).slice(0, set) : moving
      count(counts, skin, chosen, heads, set === MIXED ? unlabelledShapes(skin) : [])
    }
  }
  for (const { set, counts } of sets) yield { head, templates, set, counts }
}

function hashOf(name: string): number {
  return [...name].reduce((sum, c) => (Math.imul(31, sum) + c.charCodeAt(0)) >>> 0, 0)
}

function isMoving({ targets }: Skin, index: number): boolean {
  return Array.from(targets[index]!.offsets).some((x) => Math.abs(x) > 1e-5)
}

function shuffled(values: readonly number[], random: () => number): number[] {
  return values
    .map((value) => [random(), value] as const)
    .sort(([a], [b]) => a - b)
    .map(([, value]) => value)
}

function count(
  counts: Counts,
  skin: Skin,
  chosen: readonly number[],
  heads: readonly TemplateHead[],
  others: Skin['targets'],
): void {
  const all = [...chosen.map((index) => skin.targets[index]!), ...others]
  const targets = all.map(({ offsets }, i) => ({ name: `${i}`, offsets }))
  const { shapes } = recogniseShapes({ ...skin, targets }, heads)
  for (const [i, { name }] of all.entries()) {
    const truth = canonicalTargetName(name)
    if (labelOf(truth)) add(counts, shapes[i]!, truth)
    else if (i >= chosen.length) addOther(counts, shapes[i]!)
  }
}

function add(counts: Counts, found: RecognisedShape, truth: string): void {
  const { shape } = found
  counts.all++
  counts[shape === undefined ? 'unknown' : shape === truth ? 'right' : 'wrong']++
  if (KEY_SHAPES.test(truth)) {
    counts.key++
    if (shape === truth) counts.keyRight++
  }
  addSure(counts, found, truth)
}

/** Counts a shape outside ARKit's set. Any ARKit name for it is wrong. */
function addOther(counts: Counts, found: RecognisedShape): void {
  if (found.shape !== undefined) counts.wrong++
  addSure(counts, found, undefined)
}

function addSure(counts: Counts, { shape, confidence }: RecognisedShape, truth: string | undefined): void {
  if (confidence <= SURE) return
  counts.sure++
  if (shape !== truth) counts.sureWrong++
}

function noCounts(): Counts {
  return { all: 0, right: 0, unknown: 0, wrong: 0, key: 0, keyRight: 0, sure: 0, sureWrong: 0 }
}

const number = (value: number) => value.toLocaleString('en')

export function formatRow({ head, templates, set, counts }: Row): string {
  const { all, right, unknown, wrong, key, keyRight, sure, sureWrong } = counts
  const cells = [
    head,
    templates,
    `${set}`,
    `${number(right)} of ${number(all)}`,
    number(unknown),
    number(wrong),
    `${number(keyRight)} of ${number(key)}`,
    `${number(sureWrong)} of ${number(sure)}`,
  ]
  return `| ${cells.join(' | ')} |`
}
