import { describe, expect, it } from 'vitest'
import { SOURCES, type SourceName } from '../../../packages/cli/src/live/sources.ts'
import { seeded } from '../../random.ts'
import {
  ifacialmocapPacket,
  liveLinkPacket,
  liveLinkValues,
  openSeePacket,
  oscBundle,
  oscMessage,
  vmcMessages,
} from './packets.ts'

const read = (source: SourceName, ...packets: Uint8Array[]) => {
  const reader = SOURCES[source].createReader()
  return packets.map(reader).at(-1)
}

describe('Live Link Face', () => {
  it('reads 52 blendshapes', () => {
    const scores = read(
      'live-link-face',
      liveLinkPacket(liveLinkValues({ 0: 0.25, 13: 0.5, 43: 0.75, 51: 1, 52: 0.3 })),
    )!
    expect(Object.keys(scores)).toHaveLength(52)
    expect(scores).toMatchObject({ eyeBlinkLeft: 0.25, eyeWideRight: 0.5, browInnerUp: 0.75, tongueOut: 1 })
    expect(scores).toMatchObject({ jawOpen: 0, mouthSmileLeft: 0, noseSneerRight: 0 })
  })

  it.each([
    ['without a face', liveLinkPacket([])],
    ['of another version', liveLinkPacket(liveLinkValues({}), { version: 5 })],
    ['with fewer values than it tells', liveLinkPacket([1, 2], { count: 61 })],
    ['with more values than it tells', liveLinkPacket(liveLinkValues({}), { count: 52 })],
    ['with NaN', liveLinkPacket(liveLinkValues({ 5: Number.NaN }))],
    ['with a name of negative length', Buffer.from([6, 255, 255, 255, 255, 0, 0, 0, 0])],
    ['with a name of 2 GB', Buffer.from([6, 127, 255, 255, 255, 0, 0, 0, 0])],
  ])('ignores a packet %s', (_, packet) => expect(read('live-link-face', packet)).toBeNull())
})

describe('VMC', () => {
  it('reads a bundle, and messages in packets of their own', () => {
    const scores = { Joy: 0.5, BrowInnerUp: 0.25 }
    expect(read('vmc', oscBundle(...vmcMessages(scores)))).toEqual(scores)
    expect(read('vmc', ...vmcMessages(scores))).toEqual(scores)
    expect(read('vmc', oscBundle(oscBundle(...vmcMessages(scores))))).toEqual(scores)
  })

  it('waits for the end of a frame, and keeps values that are not sent again', () => {
    const reader = SOURCES.vmc.createReader()
    expect(vmcMessages({ A: 0.5, I: 0.25 }).map(reader)).toEqual([null, null, null, { A: 0.5, I: 0.25 }])
    expect(reader(oscBundle(...vmcMessages({ A: 1 })))).toEqual({ A: 1, I: 0.25 })
  })

  it.each([
    ['with another address', oscMessage('/VMC/Ext/Bone/Pos', 'Head', 1)],
    ['that is no OSC', Buffer.from('hello')],
    ['that ends in a string', Buffer.from('/VMC/Ext/Blend/Val')],
    ['with NaN', oscBundle(...vmcMessages({ A: Number.NaN }))],
    [
      'with bundles in bundles',
      Array.from({ length: 40 }).reduce<Buffer>(
        (inner) => oscBundle(inner),
        oscBundle(...vmcMessages({ A: 1 })),
      ),
    ],
    ['with a bundle longer than the packet', Buffer.concat([oscBundle(), Buffer.from([127, 255, 255, 255])])],
    [
      'with a blob of negative length',
      Buffer.concat([oscMessage('/a').subarray(0, 4), Buffer.from(',bs\0'), Buffer.from([255, 255, 255, 0])]),
    ],
  ])('ignores a packet %s', (_, packet) => expect(read('vmc', packet)).toBeNull())

  it('keeps at most 256 names of at most 64 characters', () => {
    const many = Object.fromEntries(Array.from({ length: 300 }, (_, i) => [`shape${i}`, 0.5]))
    expect(Object.keys(read('vmc', ...vmcMessages(many))!)).toHaveLength(256)
    expect(read('vmc', ...vmcMessages({ ['x'.repeat(65)]: 1, A: 1 }))).toEqual({ A: 1 })
  })
})

describe('iFacialMocap', () => {
  it.each(['-', '&', ' & '])('reads names and values that "%s" separates', (separator) =>
    expect(
      read('ifacialmocap', ifacialmocapPacket({ mouthSmile_R: 12, browInnerUp: 100 }, separator)),
    ).toEqual({
      mouthSmile_R: 0.12,
      browInnerUp: 1,
    }),
  )

  it.each([
    ['of the head alone', ifacialmocapPacket({})],
    ['with other text', Buffer.from('hello|world=')],
    ['of bytes that are no text', Buffer.from([255, 254, 0, 45, 48, 124])],
    ['that is empty', Buffer.alloc(0)],
  ])('ignores a packet %s', (_, packet) => expect(read('ifacialmocap', packet)).toBeNull())
})

describe('OpenSeeFace', () => {
  const features = Array.from({ length: 14 }, (_, i) => (i - 7) / 8)

  it('reads the features of the first face', () => {
    const scores = read('openseeface', openSeePacket(features))!
    expect(Object.keys(scores)).toHaveLength(14)
    expect(scores).toMatchObject({
      EyeLeft: -0.875,
      EyeRight: -0.75,
      EyebrowUpDownLeft: -0.5,
      EyebrowQuirkRight: 0,
    })
    expect(scores).toMatchObject({
      MouthCornerUpDownLeft: 0.125,
      MouthCornerInOutRight: 0.5,
      MouthOpen: 0.625,
      MouthWide: 0.75,
    })
    expect(read('openseeface', Buffer.concat([openSeePacket(features), openSeePacket([])]))).toEqual(scores)
  })

  it.each([
    ['without a face', openSeePacket(features, false)],
    ['that is a byte short', openSeePacket(features).subarray(1)],
    ['that is empty', Buffer.alloc(0)],
    ['with infinity', openSeePacket([Number.POSITIVE_INFINITY])],
  ])('ignores a packet %s', (_, packet) => expect(read('openseeface', packet)).toBeNull())
})

describe.each(Object.keys(SOURCES) as SourceName[])('%s', (source) => {
  const packets: Record<SourceName, Buffer> = {
    'live-link-face': liveLinkPacket(liveLinkValues({ 3: 0.5 })),
    vmc: oscBundle(...vmcMessages({ A: 0.5, Joy: 1 })),
    ifacialmocap: ifacialmocapPacket({ mouthSmile_R: 12 }),
    openseeface: openSeePacket([0.5]),
  }

  it('survives truncated and damaged packets, and delivers only finite scores', () => {
    const random = seeded(1)
    const reader = SOURCES[source].createReader()
    const whole = packets[source]
    const step = Math.ceil(whole.length / 300)
    for (let i = 0; i < whole.length; i += step) {
      const damaged = Buffer.from(whole)
      damaged[i] = 256 * random()
      for (const packet of [whole.subarray(0, i), damaged]) {
        const scores = reader(packet) ?? {}
        expect(Object.values(scores).every(Number.isFinite)).toBe(true)
      }
    }
    expect(reader(whole)).not.toBeNull()
  })
})
