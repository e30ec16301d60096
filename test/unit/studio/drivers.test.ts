import { parseDrivers, type WrinkleDriver } from 'furrow'
import { explain } from 'furrow/internal'
import { describe, expect, it } from 'vitest'
import { addDriver, recordPose, removeDriver, setDriver } from '../../../studio/src/document/drivers.ts'
import { DRIVERS, frozen, sampleDocument } from './sample-document.ts'

const document = frozen(sampleDocument())
const driver = document.drivers[0]

/** Returns the sum of the last driver's links at the weights of a pose. */
function sumIn(pose: ReadonlyMap<string, number>, drivers: readonly WrinkleDriver[]): number {
  const { targets } = drivers.at(-1) as { targets: { name: string; weight: number }[] } & WrinkleDriver
  return targets.reduce((sum, { name, weight }) => sum + weight * pose.get(name)!, 0)
}

describe('recording a pose', () => {
  it.each([
    [{ browInnerUp: 1 }],
    [{ browInnerUp: 0.4, browOuterUpLeft: 0.9, jawOpen: 0.02 }],
    [{ browInnerUp: 0.011 }],
  ])('makes a driver whose sum is 1 in the pose: %j', (weights) => {
    const pose = new Map(Object.entries(weights))
    const after = recordPose(document, 'cheeks', pose)
    expect(after.drivers.at(-1)).toMatchObject({ type: 'morph', area: 'cheeks', rule: 'sum' })
    expect(sumIn(pose, after.drivers)).toBeCloseTo(1, 2)
    expect(after.areas).toBe(document.areas)
  })

  it('makes a driver whose sum is 1 in the pose, even with many blendshapes', () => {
    const pose = new Map(Array.from({ length: 60 }, (_, i) => [`shape ${i}`, 0.5]))
    expect(sumIn(pose, recordPose(document, 'cheeks', pose).drivers)).toBeCloseTo(1, 2)
  })

  it('replaces only the morph drivers of this area', () => {
    const after = recordPose(document, 'frown', new Map([['jawOpen', 1]]))
    expect(after.drivers.length).toBe(document.drivers.length)
    expect(after.drivers).not.toContain(document.drivers[1])
    expect(document.drivers.filter((each) => after.drivers.includes(each))).toHaveLength(6)
  })

  it('removes these drivers, and adds none, if the pose is at rest', () => {
    const after = recordPose(document, 'frown', new Map([['jawOpen', 0.005]]))
    expect(after.drivers).toEqual(document.drivers.filter((each) => each !== document.drivers[1]))
  })

  it('makes a driver whose sum is 1 for the weights that remain after conflicts', () => {
    const pose = new Map([
      ['browInnerUp', 1],
      ['browDownLeft', 0.25],
    ])
    const after = recordPose(document, 'cheeks', pose)
    const [read] = explain(
      after.drivers.slice(-1).concat(DRIVERS.filter(({ type }) => type === 'conflict')),
      [{ name: 'cheeks' }],
      {
        targetNames: [...pose.keys()],
        weights: [...pose.values()],
      },
    )
    expect(read.activation).toBeCloseTo(1, 2)
    expect(read.parts[0].links.map(({ link }) => link.name)).toEqual(['browInnerUp'])
  })

  it('throws if the blendshapes of the pose cancel each other', () => {
    const pose = new Map([
      ['browInnerUp', 0.5],
      ['browDownLeft', 0.5],
    ])
    expect(() => recordPose(document, 'cheeks', pose)).toThrow(
      'cancel each other, got "browInnerUp, browDownLeft"',
    )
  })

  it('throws for an unknown area', () => {
    expect(() => recordPose(document, 'nose', new Map())).toThrow('no such area')
  })
})

describe('a driver', () => {
  it('can be added, replaced and removed, and others keep their positions', () => {
    const added = addDriver(document, { type: 'morph', area: 'cheeks', targets: [{ name: 'smile' }] })
    expect(added.drivers.slice(0, 7).every((each, i) => each === document.drivers[i])).toBe(true)
    const [whole] = parseDrivers(
      [{ type: 'morph', area: 'cheeks', targets: [{ name: 'smile' }] }],
      ['cheeks'],
    )
    expect(added.drivers[7]).toEqual(whole)
    const replaced = setDriver(document, 1, driver)
    expect(replaced.drivers[1]).toEqual(driver)
    expect(replaced.drivers[2]).toBe(document.drivers[2])
    expect(removeDriver(document, 0).drivers).toEqual(document.drivers.slice(1))
  })

  it('is refused if it is malformed or names an unknown area', () => {
    const wrong = { ...driver, area: 'nose' } as WrinkleDriver
    expect(() => addDriver(document, wrong)).toThrow('Studio: drivers[0].area')
    expect(() => setDriver(document, 0, { type: 'morph', area: 'frown' })).toThrow('drivers[0].targets')
  })
})
