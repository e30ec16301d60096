import type { FurrowError } from 'furrow'
import { autoWrinkles, type Skin } from 'furrow/author'
import {
  correctSkin,
  faceShapeFinder,
  parseCorrections,
  recogniseShapes,
  type ShapeCorrection,
} from 'furrow/internal'
import { beforeAll, describe, expect, it } from 'vitest'
import { knownTargets } from '../../../../packages/furrow/src/author/auto/surface/known-targets.ts'
import { TEMPLATE_FACES } from '../../../../scripts/lib/shape-templates.ts'
import { skinAt } from '../../../skin-at.ts'

let human: Skin

beforeAll(async () => {
  human = await skinAt(TEMPLATE_FACES.builder[1])
})

const indexOf = (name: string) => human.targets.findIndex((target) => target.name === name)
const corrected = (...corrections: ShapeCorrection[]) => correctSkin(human, corrections, ['skin'])

/** Returns the indices of the blendshapes that automatic wrinkles use as a shape of ARKit. */
function found(skin: Skin, shape: string): number[] {
  const { known, hints } = knownTargets(skin)
  return faceShapeFinder(known, hints)(shape)
}

describe('corrections in a file', () => {
  it.each([
    ['no list', { target: 'a' }, 'shapes must be an array'],
    ['no object', ['a'], 'shapes[0] must be an object'],
    ['no target', [{ shape: 'jawOpen' }], 'shapes[0].target must be text'],
    ['an empty name', [{ target: '' }], 'shapes[0].target must be text'],
    ['a name that is too long', [{ target: 'a', mesh: 'x'.repeat(257) }], 'shapes[0].mesh must be text'],
    ['another rig', [{ target: 'a', shape: 'CTRL_expressions_jawOpen' }], 'shapes[0].shape is unknown'],
    ['a misspelt shape', [{ target: 'a', shape: 'browInerUp' }], 'did you mean "browInnerUp"?'],
    ['null', [{ target: 'a', shape: null }], 'shapes[0].shape must be text'],
    ['too many', Array(1025).fill({ target: 'a' }), 'shapes has the wrong number of items'],
  ])('are refused with the name of the invalid field: %s', (_, json, message) => {
    expect(() => parseCorrections(json, 'test')).toThrow(message)
  })

  it('are read without malformed ones if the caller collects errors', () => {
    const errors: FurrowError[] = []
    const json = [
      { target: 'a', shape: 'jawOpen', extras: {} },
      { target: 'b', shape: 'joy' },
      { target: 'c' },
    ]
    const read = parseCorrections(json, 'test', (error) => errors.push(error))
    expect(read).toEqual([{ target: 'a', shape: 'jawOpen' }, { target: 'c' }])
    expect(errors).toHaveLength(1)
    expect(parseCorrections('none', 'test', (error) => errors.push(error))).toEqual([])
    expect(errors).toHaveLength(2)
    expect(parseCorrections(undefined, 'test')).toEqual([])
  })
})

describe('a correction', () => {
  it.each<[string, Partial<ShapeCorrection>, boolean]>([
    ['its mesh', { mesh: 'skin' }, true],
    ['any mesh', {}, true],
    ['another mesh', { mesh: 'body' }, false],
    ['another spelling', { target: 'BrowInner_Up' }, true],
    ['no target of the mesh', { target: 'other' }, false],
  ])('finds its blendshape like a driver does, with %s', (_, names, isFound) => {
    const { targets } = corrected({ target: 'browInnerUp', shape: 'jawOpen', ...names })
    const changed = targets.flatMap(({ correction }, i) =>
      correction === undefined ? [] : [[i, correction]],
    )
    expect(changed).toEqual(isFound ? [[indexOf('browInnerUp'), 'jawOpen']] : [])
  })

  it('is used if it is the first of two for one blendshape', () => {
    const skin = corrected({ target: 'jawOpen' }, { target: 'jawOpen', shape: 'mouthSmile' })
    expect(skin.targets[indexOf('jawOpen')]!.correction).toBeNull()
  })

  it('overrides motion and name, with full confidence', () => {
    const { shapes } = recogniseShapes(
      corrected({ target: 'browInnerUp', shape: 'cheekPuff' }, { target: 'mouthSmileLeft' }),
    )
    const [brow, smile] = ['browInnerUp', 'mouthSmileLeft'].map((name) => shapes[indexOf(name)]!)
    expect(brow).toMatchObject({ shape: 'cheekPuff', confidence: 1, by: 'correction' })
    expect(smile).toMatchObject({ shape: undefined, confidence: 1, by: 'correction', hint: undefined })
  })

  it('decides which blendshapes automatic wrinkles use for a shape', () => {
    const [up, sneer] = [indexOf('browInnerUp'), indexOf('noseSneerLeft')]
    expect(found(human, 'browInnerUp')).toEqual([up])
    // A correction excludes the blendshape that only has the right name.
    expect(found(corrected({ target: 'noseSneerLeft', shape: 'browInnerUp' }), 'browInnerUp')).toEqual([
      sneer,
    ])
    expect(found(corrected({ target: 'browInnerUp' }), 'browInnerUp')).not.toContain(up)
    const both = corrected({ target: 'noseSneerLeft', shape: 'mouthSmile' })
    expect(found(both, 'mouthSmile')).toEqual([sneer])
    const half = corrected({ target: 'browInnerUp' }, { target: 'noseSneerLeft', shape: 'browInnerUpLeft' })
    expect(found(half, 'browInnerUp')).toEqual([sneer])
  })

  it('to a shape that ARKit lacks is refused', () => {
    const skin = corrected({ target: 'browInnerUp', shape: 'joy' })
    expect(() => autoWrinkles(skin)).toThrow(
      'the correction of blendshape "browInnerUp" is unknown, got "joy"',
    )
  })

  it('allows another blendshape to be recognised as the former shape', () => {
    const [up, wide] = ['browInnerUp', 'eyeWideLeft'].map((name) => human.targets[indexOf(name)]!)
    const offsets = Float32Array.from(up!.offsets, (x, i) => x + 0.8 * wide!.offsets[i]!)
    const others = human.targets.filter((target) => target !== up)
    const skin = { ...human, targets: [{ ...up!, name: 'slider' }, { name: 'key', offsets }, ...others] }
    const [, taken] = recogniseShapes(skin).shapes
    expect(taken!.shape).not.toBe('browInnerUp')
    const [, freed] = recogniseShapes(correctSkin(skin, [{ target: 'slider' }], [])).shapes
    expect(freed).toMatchObject({ shape: 'browInnerUp', by: 'geometry' })
  })
})
