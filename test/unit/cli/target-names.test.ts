import { describe, expect, it } from 'vitest'
import { namesOfTargets } from '../../../packages/files/src/json/gltf-json.ts'

describe('names of blendshapes', () => {
  it('are those of extras.targetNames', () => {
    expect(namesOfTargets(['a', '', 7], 3)).toEqual(['a', '', '7'])
  })

  it('are indices where there are none, too few, or too many', () => {
    expect(namesOfTargets(undefined, 2)).toEqual(['0', '1'])
    expect(namesOfTargets('ab', 2)).toEqual(['0', '1'])
    expect(namesOfTargets(['a'], 2)).toEqual(['0', '1'])
    expect(namesOfTargets(['a', 'b', 'c'], 2)).toEqual(['0', '1'])
  })

  it('are indices where a name is no text', () => {
    expect(namesOfTargets(['a', {}, null, { toString: 1, valueOf: null }, []], 5)).toEqual([
      'a',
      '1',
      '2',
      '3',
      '4',
    ])
  })
})
