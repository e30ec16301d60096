import { describe, expect, it } from 'vitest'
import type { StudioDocument } from '../../../studio/src/document/document.ts'
import {
  durationOf,
  MAX_TAKES,
  motionOf,
  rangeOf,
  trimmed,
  weightsOf,
} from '../../../studio/src/document/take.ts'
import { addTake, removeTake, renameTake, trimTake } from '../../../studio/src/document/takes.ts'
import { parseTakeFile, takeFile } from '../../../studio/src/keep/take-file.ts'
import { frozen, sampleDocument } from './sample-document.ts'

const { takes: _, ...empty } = sampleDocument()
const start: StudioDocument = frozen(empty)
/** A jaw that opens in two seconds. */
const motion = motionOf([10, 12], [['jawOpen', [0, 1]]])
const take = { name: 'Take 1', motion }
const names = (document: StudioDocument) => document.takes?.map(({ name }) => name)

describe('a motion', () => {
  it('has 60 key frames per second between its samples', () => {
    expect(durationOf(motion)).toBe(2)
    expect(motion.weights).toHaveLength(121)
    expect([0, 30, 60, 120].map((frame) => motion.weights[frame])).toEqual([0, 0.25, 0.5, 1])
  })

  it('omits blendshapes that stay at 0, and keeps one if nothing moves', () => {
    expect(motionOf([0, 1], [['a', [0, 0]], ['b', [0, 1]]]).names).toEqual(['b']) // biome-ignore format: short
    expect(motionOf([0, 1], [['a', [0, 0]], ['b', [0, 0]]]).names).toEqual(['a']) // biome-ignore format: short
  })

  it('keeps weights in 0..1, also those of sources that exceed it', () => {
    const { weights } = motionOf([0, 1 / 60], [['a', [-0.5, 1.5]]])
    expect([...weights]).toEqual([0, 1])
  })

  it.each([
    ['has no motion', [0]],
    ['is too long', [0, 2001]],
  ])('is refused if it %s', (problem, times) => {
    expect(() => motionOf(times, [['a', times.map(() => 1)]])).toThrow(problem)
  })
})

describe('takes of a document', () => {
  it('get free names, and can be renamed', () => {
    const two = addTake(addTake(start, take), take)
    expect(names(two)).toEqual(['Take 1', 'Take 2'])
    expect(names(renameTake(two, 'Take 1', 'Smile'))).toEqual(['Smile', 'Take 2'])
    expect(() => renameTake(two, 'Take 1', 'Take 2')).toThrow('already has this name')
    expect(() => renameTake(two, 'Take 1', '')).toThrow('no usable name')
    expect(renameTake(two, 'Take 1', 'Take 1')).toBe(two)
  })

  it('have a maximum number', () => {
    const takes = Array.from({ length: MAX_TAKES }, (_, i) => ({ ...take, name: `${i}` }))
    expect(() => addTake({ ...start, takes }, take)).toThrow('too many takes, got 257, allowed: 256')
  })

  it('can be deleted, and without takes the document is as before', () => {
    const one = addTake(start, take)
    expect(removeTake(one, 'Take 1')).toEqual(start)
    expect(() => removeTake(one, 'gone')).toThrow('no such take')
  })

  it.each<[string, [number, number], readonly number[]]>([
    ['inside', [0.5, 1.5], [0.5, 1.5]],
    ['beyond both ends', [-1, 9], [0, 2]],
    ['in one point', [1, 1], [1, 1 + 1 / 60]],
    ['in the last point', [2, 2], [2 - 1 / 60, 2]],
  ])('are trimmed %s without a change of their key frames', (_, range, expected) => {
    const [result] = trimTake(addTake(start, take), 'Take 1', range).takes!
    expect(rangeOf(result)).toEqual(expected)
    expect(result.motion).toBe(motion)
  })

  it('are whole again without a range', () => {
    const cut = trimTake(addTake(start, take), 'Take 1', [1, 1.5])
    expect(trimTake(cut, 'Take 1', [0, 2])).toEqual(addTake(start, take))
  })
})

it('a trimmed take has the key frames between its in and out points', () => {
  const part = trimmed({ ...take, range: [0.5, 1] })
  expect(durationOf(part)).toBe(0.5)
  expect(weightsOf(part, 0)).toEqual(weightsOf(motion, 0).slice(30, 61))
  expect(trimmed(take)).toBe(motion)
})

describe('the file of a take', () => {
  const whole = { name: 'Smile', motion: motionOf([0, 0.21], [['a', [1 / 3, 1]], ['b', [0, 0.1]]]), range: [0.05, 0.1] } as const // biome-ignore format: short
  const json = () => JSON.parse(new TextDecoder().decode(takeFile(whole)))

  it('is read as the same take', () => {
    expect(parseTakeFile(json(), 'takes/Smile.json')).toEqual(whole)
  })

  it.each([
    ['version', 2],
    ['rate', 30],
    ['name', ''],
    ['names', []],
    ['names', ['a']],
    ['weights', [[0, 1], [0]]],
    [
      'weights',
      [
        [0, 2],
        [0, 1],
      ],
    ],
    ['range', [0.1, 0.05]],
    ['range', [0, 9]],
  ])('is refused if %s is %j', (field, value) => {
    expect(() => parseTakeFile({ ...json(), [field]: value }, 'takes/Smile.json')).toThrow(
      /^takes\/Smile.json: /,
    )
  })
})
