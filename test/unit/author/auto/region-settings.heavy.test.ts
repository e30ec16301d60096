import { type AutoOptions, type AutoWrinkles, autoWrinkles, type Skin, type Stroke } from 'furrow/author'
import { strokesOf } from 'furrow/internal'
import { beforeAll, expect, test } from 'vitest'
import { skinAt } from '../../../skin-at.ts'
import { FACES } from './faces.ts'

let skin: Skin
let plain: AutoWrinkles

beforeAll(async () => {
  const [[, path]] = FACES
  skin = await skinAt(path)
  plain = make({})
})

function make(options: AutoOptions): AutoWrinkles {
  return autoWrinkles(skin, { size: 16, areaSize: 64, age: 60, seed: 1, ...options })
}

/** Returns the strokes of each group. All strokes of the forehead are in the group `foreheadOuter`. */
function groupsOf(made: AutoWrinkles): Map<string, Stroke[]> {
  const groups = new Map<string, Stroke[]>()
  for (const stroke of strokesOf(made).strokes)
    groups.set(stroke.group!, [...(groups.get(stroke.group!) ?? []), stroke])
  return groups
}

/** Returns the depth at each end and at each factor of a stroke. */
function depthsOf({ depth, depths = [1] }: Stroke): number[] {
  return depths.map((factor) => depth * factor)
}

test('the strength of a region scales the depth of its lines and bulges, and changes nothing else', () => {
  const half = make({ strengths: { crowsFeet: 0.5, bag: 0.5, glabella: 0.5, glabellaRight: 1 } })
  const [before, after] = [groupsOf(plain), groupsOf(half)]
  expect([...after.keys()]).toEqual([...before.keys()])
  const changed = ['crowsFeetLeft', 'crowsFeetRight', 'bagLeft', 'bagRight', 'glabellaLeft']
  for (const [group, strokes] of before) {
    if (!changed.includes(group)) expect(after.get(group), group).toEqual(strokes)
    else {
      const ratios = after.get(group)!.map(({ depth }, i) => depth / strokes[i].depth)
      for (const ratio of ratios) expect(ratio, group).toBeCloseTo(0.5, 2)
    }
  }
  expect(half.areas).toEqual(plain.areas)
})

test('the strengths of the forehead blend along the lines that its regions share', () => {
  const strong = groupsOf(make({ strengths: { foreheadInner: 2, foreheadOuterLeft: 0 } }))
  const ratios = strong.get('foreheadOuter')!.flatMap((stroke, i) => {
    const before = depthsOf(groupsOf(plain).get('foreheadOuter')![i])
    return depthsOf(stroke).flatMap((depth, k) => (before[k] > 0.3 ? depth / before[k] : []))
  })
  // The right outer forehead is unchanged, the inner forehead is twice as deep, and the left outer forehead is flat.
  expect(Math.max(...ratios)).toBeCloseTo(2, 1)
  expect(Math.min(...ratios)).toBeLessThan(0.05)
  expect(ratios.some((ratio) => Math.abs(ratio - 1) < 0.02)).toBe(true)
})

test('the density of a region changes the number of its lines, and changes no other lines', () => {
  const counts = ({ crowsFeet, upperLip }: { crowsFeet: number; upperLip: number }) => {
    const groups = groupsOf(make({ densities: { crowsFeet, upperLip } }))
    for (const [group, strokes] of groupsOf(plain))
      if (!/^(crowsFeet|upperLip)/.test(group)) expect(groups.get(group), group).toEqual(strokes)
    return ['crowsFeetLeft', 'crowsFeetRight', 'upperLip'].map((group) => groups.get(group)!.length)
  }
  const before = ['crowsFeetLeft', 'crowsFeetRight', 'upperLip'].map(
    (group) => groupsOf(plain).get(group)!.length,
  )
  for (const [i, count] of counts({ crowsFeet: 2, upperLip: 2 }).entries())
    expect(count / before[i]).toBeGreaterThan(1.6)
  for (const [i, count] of counts({ crowsFeet: 0.5, upperLip: 0.5 }).entries())
    expect(count / before[i]).toBeLessThan(0.7)
})
