import { parseDrivers } from 'furrow'
import { describe, expect, it } from 'vitest'
import { addArea, mirrorArea, mirroredName } from '../../../studio/src/document/areas.ts'
import { addDriver } from '../../../studio/src/document/drivers.ts'
import { otherSide, splitSide } from '../../../studio/src/document/sides.ts'
import { areaOf, frozen, sampleDocument, weightsOf } from './sample-document.ts'

it.each([
  ['crowsFeetLeft', 'crowsFeetRight'],
  ['leftCheek', 'rightCheek'],
  ['brow_right_outer', 'brow_left_outer'],
  ['browOuterUp_L', 'browOuterUp_R'],
  ['Lefty', 'Lefty'],
  ['forehead', 'forehead'],
])('the other side of %s is %s', (name, other) => {
  expect(otherSide(name)).toBe(other)
})

describe('an area on the other side', () => {
  const one = addArea(sampleDocument(), areaOf('cheekLeft', 'up'))
  const [driver] = parseDrivers(
    [
      {
        type: 'morph',
        area: 'cheekLeft',
        targets: [{ name: 'cheekSquintLeft', weight: 0.5 }, { name: 'jawOpen' }],
      },
    ],
    ['cheekLeft'],
  )
  const document = frozen(addDriver(one, driver))

  it('is added with drivers that read the blendshapes of its side', () => {
    const both = mirrorArea(document, 'cheekLeft', weightsOf(7))
    expect(both.areas.at(-1)).toMatchObject({ name: 'cheekRight', layer: 'up', weights: weightsOf(7) })
    expect(both.drivers.at(-1)).toMatchObject({
      area: 'cheekRight',
      targets: [{ name: 'cheekSquintRight', weight: 0.5 }, { name: 'jawOpen' }],
    })
  })

  it('is repainted if it exists, and keeps its drivers', () => {
    const both = mirrorArea(document, 'cheekLeft', weightsOf(7))
    const again = mirrorArea(both, 'cheekLeft', weightsOf(9))
    expect(again.areas.length).toBe(both.areas.length)
    expect(again.areas.at(-1)?.weights).toEqual(weightsOf(9))
    expect(again.drivers).toBe(both.drivers)
  })

  it('gets a new name if the name of the original has no side', () => {
    expect(mirroredName(document, 'forehead')).toBe('forehead 2')
    expect(mirrorArea(document, 'forehead', weightsOf(7)).areas.at(-1)?.name).toBe('forehead 2')
  })
})

it.each([
  ['foreheadInnerLeft', 'foreheadInner', 'Left'],
  ['mouthSmile_R', 'mouthSmile', '_R'],
  ['chin', 'chin', ''],
  ['Left', '', 'Left'],
])('the side of %s is recognised', (name, start, side) => {
  expect(splitSide(name)).toEqual([start, side])
})
