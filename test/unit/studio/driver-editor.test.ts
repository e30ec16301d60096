import { type MorphDriver, parseDrivers } from 'furrow'
import { curveAt } from 'furrow/internal'
import { describe, expect, it } from 'vitest'
import type { Drivable } from '../../../studio/src/panels/drivers/types/driver-type.ts'
import { AREA_DRIVER_TYPES, createDriver } from '../../../studio/src/panels/drivers/types/types.ts'
import { DriverEditor } from '../../../studio/src/session/driver-editor.ts'
import { Session } from '../../../studio/src/session/session.ts'
import { ramp, STRAIGHT } from '../../drivers.ts'
import { attempts, sampleDocument } from './sample-document.ts'

const face: Drivable = {
  pose: new Map([
    ['jawOpen', 0.2],
    ['browInnerUp', 0.9],
  ]),
  targets: ['browDownLeft', 'browInnerUp', 'jawOpen'],
  joints: [['neck', 'head']],
  muscle: () => ({ origin: [0, 0.1, 0], insertion: [0, 0, 0] }),
}

function open() {
  const session = new Session()
  session.open(sampleDocument())
  const { errors, attempt } = attempts()
  const editor = new DriverEditor(session, attempt)
  return { session, editor, errors, drivers: () => session.document.peek()!.drivers }
}

describe('a new driver', () => {
  it.each(AREA_DRIVER_TYPES)('of type %s is valid in files, can be added, and is removed by undo', (type) => {
    const { session, editor, errors, drivers } = open()
    const before = drivers()
    editor.add(createDriver(type, 'cheeks', session.document.peek()!, face)!)
    expect(errors).toEqual([])
    expect(drivers()).toHaveLength(before.length + 1)
    expect(drivers().at(-1)!.type).toBe(type)
    session.undo()
    expect(drivers()).toBe(before)
  })

  it('reads the blendshape with the highest weight', () => {
    const { targets } = createDriver('morph', 'cheeks', sampleDocument(), face) as MorphDriver
    expect(targets[0].name).toBe('browInnerUp')
  })

  it('gets the name of an input that no other driver has', () => {
    const document = sampleDocument()
    const first = createDriver('input', 'cheeks', document, face)!
    const second = createDriver('input', 'cheeks', { ...document, drivers: [first] }, face)!
    expect((second as { name: string }).name).not.toBe((first as { name: string }).name)
  })

  it('is not offered if the face has nothing that it could read', () => {
    const bare: Drivable = { pose: new Map(), targets: [], joints: [], muscle: () => null }
    const { areas, ...document } = sampleDocument()
    const alone = { ...document, areas: areas.slice(0, 1) }
    for (const type of ['morph', 'area', 'bone', 'muscle'] as const) {
      expect(createDriver(type, areas[0].name, alone, bare)).toBeNull()
    }
  })
})

describe('a change of a driver', () => {
  it('is one undo step until a dragged point is released, and another step afterwards', () => {
    const { session, editor, drivers } = open()
    const before = drivers()
    const drag = (input: number) => editor.set(0, 'curve', { curve: ramp(input, 1) })
    for (const input of [0.1, 0.2, 0.3]) drag(input)
    editor.settle()
    drag(0.5)
    editor.settle()
    const curve = () => (drivers()[0] as MorphDriver).curve
    expect(curve()[0][0]).toBe(0.5)
    session.undo()
    expect(curve()[0][0]).toBe(0.3)
    session.undo()
    expect(drivers()).toBe(before)
    session.redo()
    expect(curveAt(curve(), 0.65)).toBeCloseTo(0.5, 10)
  })

  it('is a step for each of two drivers', () => {
    const { session, editor, drivers } = open()
    editor.set(0, 'rule', { rule: 'max' })
    editor.set(1, 'rule', { rule: 'max' })
    session.undo()
    expect((drivers()[0] as MorphDriver).rule).toBe('max')
    expect((drivers()[1] as MorphDriver).rule).toBe('sum')
  })

  it('is refused with an error if it is invalid in files, and the driver stays', () => {
    const { editor, errors, drivers } = open()
    const before = drivers()
    editor.set(0, 'curve', { curve: [[0, 0]] })
    expect(errors[0]).toContain('Studio: drivers[0].curve')
    expect(drivers()).toBe(before)
  })

  it('removes a field that is set to undefined', () => {
    const { session, editor, drivers } = open()
    const bone = { type: 'bone', joints: ['a', 'b'], measure: 'angle', axis: [1, 0, 0] }
    const [driver] = parseDrivers(
      [
        {
          ...bone,
          area: 'cheeks',
          curve: STRAIGHT,
        },
      ],
      ['cheeks'],
    )
    editor.add(driver)
    editor.set(session.document.peek()!.drivers.length - 1, 'axis', { axis: undefined })
    expect(drivers().at(-1)).not.toHaveProperty('axis')
  })

  it('can remove the driver, and undo restores it at its position', () => {
    const { session, editor, drivers } = open()
    const before = drivers()
    editor.remove(1)
    expect(drivers()).toEqual(before.filter((_, i) => i !== 1))
    session.undo()
    expect(drivers()).toBe(before)
  })
})
