import { describe, expect, it, test, vi } from 'vitest'
import { remake } from '../../../studio/src/document/automatic.ts'
import {
  AUTO_SETTINGS,
  type AutoSettings,
  type LayerStroke,
  type StudioDocument,
} from '../../../studio/src/document/document.ts'
import { applyPreset, presetOf } from '../../../studio/src/document/preset.ts'
import { setDepth, setStrength } from '../../../studio/src/document/region.ts'
import { readPreset } from '../../../studio/src/open/read-preset.ts'
import { Opening, type OpeningParts } from '../../../studio/src/session/opening.ts'
import { Session } from '../../../studio/src/session/session.ts'
import { areaOf, frozen, sampleDocument, strokeOf } from './sample-document.ts'

const NAMES = ['crowsFeetLeft', 'crowsFeetRight', 'foreheadInnerLeft', 'foreheadOuterLeft']

const automatic = (group: string): LayerStroke => ({ ...strokeOf('up', group), isAutomatic: true })

/** Document with automatic wrinkles. All lines of the forehead are in one group, as `furrow auto` makes them. */
const document: StudioDocument = frozen({
  ...sampleDocument(),
  areas: NAMES.map((name) => ({ ...areaOf(name, 'up'), isAutomatic: true })),
  strokes: ['crowsFeetLeft', 'crowsFeetRight', 'foreheadOuter'].map(automatic),
  drivers: NAMES.map((area) => {
    const curve = [
      [0, 0],
      [1, 1],
    ]
    return { type: 'morph', area, targets: [{ name: 'browInnerUp' }], curve } as never
  }),
  auto: { age: 60, strength: 1.2, size: 2048, seed: 7, seeds: { chin: 2 }, densities: { nose: 2 } },
})

const fileOf = (text: string) => ({ path: 'old.json', file: new File([text], 'old.json') })
const preset = ({ auto }: StudioDocument) => presetOf(auto!)

describe('a preset', () => {
  it('carries the settings and the changes of regions to another avatar, which keeps its seed and map size', async () => {
    const changed = setStrength(setDepth(document, 'crowsFeetLeft', 0.25), 'crowsFeetRight', 0.5)
    const text = JSON.stringify({ version: 1, ...preset(setDepth(changed, 'foreheadOuterLeft', 0.8)) })
    const other: AutoSettings = { age: 30, strength: 1, size: 512, seed: 3, symmetry: 1, regions: ['chin'] }
    expect(applyPreset(other, await readPreset(fileOf(text)))).toEqual({
      age: 60,
      strength: 1.2,
      size: 512,
      seed: 3,
      strengths: { crowsFeet: 0.5, foreheadInner: 1.6, foreheadOuter: 1.6 },
      densities: { nose: 2 },
    })
  })

  it('keeps what the surface of the avatar is', () => {
    const cloth = { ...AUTO_SETTINGS, kind: 'cloth', cloth: 'denim' } as const
    expect(applyPreset(cloth, { age: 60 })).toEqual({ ...cloth, age: 60 })
    expect(presetOf(cloth)).not.toHaveProperty('kind')
  })

  it('replaces the seed if it has one', () => {
    const settings = applyPreset({ strength: 1, size: 512, seed: 3, seeds: { chin: 4 } }, { seed: 9 })
    expect(settings).toEqual({ strength: 1, size: 512, seed: 9 })
  })

  it('has a value for one half of a region that differs from the other', () => {
    expect(preset(setDepth(document, 'crowsFeetRight', 1)).strengths).toEqual({ crowsFeetRight: 2 })
  })

  it('is unchanged by changes that are taken back, also beyond its limit', () => {
    const deep = setDepth(document, 'crowsFeetLeft', 2.5)
    expect(preset(deep).strengths).toEqual({ crowsFeetLeft: 2 })
    expect(preset(setDepth(deep, 'crowsFeetLeft', 0.5))).toEqual(preset(document))
  })

  it.each([
    ['{"version":1,"strengths":{"crowsFeet":9}}', /^Studio: old\.json: invalid strength, got 9/],
    ['{"version":3}', /^Studio: old\.json: unknown version of the preset, got 3/],
    ['{', /^Studio: cannot read old\.json/],
    [' '.repeat(65 * 2 ** 20), /^Studio: old\.json is too large/],
  ])('with errors is refused with one message (%#)', async (text, message) => {
    await expect(readPreset(fileOf(text))).rejects.toThrow(message)
  })
})

test('new automatic wrinkles replace lines of a depth that the settings can make, and keep deeper ones', () => {
  const made = { ...document, strokes: NAMES.map(automatic) }
  const kept = (depth: number) => {
    const changed = setDepth(document, 'crowsFeetLeft', depth)
    return remake(changed, made).strokes.filter((stroke) => changed.strokes.includes(stroke)).length
  }
  expect(kept(0.9)).toBe(0)
  expect(kept(1.1)).toBe(1)
})

describe('a dropped preset', () => {
  const session = new Session()
  const makeAuto = vi.fn()
  const attempt = (task: () => unknown) => task()
  const messages = { attemptOpening: attempt, note: vi.fn() }
  const opened = vi.fn(async () => {})
  const opening = new Opening({
    workspace: { session, makeAuto, opened },
    messages,
  } as unknown as OpeningParts)
  const drop = () => opening.openFiles(async () => [fileOf('{"version":1,"age":70}')])

  it('makes automatic wrinkles once', async () => {
    session.open(document)
    await drop()
    expect(makeAuto.mock.calls).toEqual([[{ age: 70, strength: 1, size: 2048, seed: 7, seeds: { chin: 2 } }]])
    expect(messages.note).toHaveBeenCalledWith('Applied old.json')
  })

  it('waits until the first wrinkles of the avatar are made', async () => {
    session.open(null)
    opened.mockImplementationOnce(async () => session.open(document))
    await drop()
    expect(makeAuto).toHaveBeenCalledTimes(2)
  })

  it('is refused if there are no automatic wrinkles', async () => {
    session.open(null)
    await expect(drop()).rejects.toThrow('there are no automatic wrinkles to which old.json applies')
  })
})
