import { expect, it } from 'vitest'
import { link, morph, ramp, STRAIGHT } from '../../drivers.ts'
import { drivenFace } from './driven-face.ts'

it('explains the activations of the last frame, joints and tension included', () => {
  const { mesh, head, wrinkles, activations } = drivenFace([
    morph('brow', [link('browDownLeft', 0.5)]),
    { type: 'tension', area: 'brow', measure: 'compression', curve: STRAIGHT },
    {
      type: 'bone',
      area: 'neck',
      joints: ['chest', 'head'],
      measure: 'angle',
      axis: [1, 0, 0],
      curve: STRAIGHT,
    },
    { type: 'age', area: 'nose', curve: ramp(20, 70, 0.5) },
    { type: 'time', area: 'neck', attack: 5, release: 5 },
  ])
  activations()
  mesh.morphTargetInfluences![0] = 0.6
  head.rotation.x = 0.4
  wrinkles.inputs.set('age', 50)
  activations()
  const [brow, nose, neck] = wrinkles.explain()
  const types = (parts: typeof brow.parts) => parts.map(({ driver, activation }) => [driver.type, activation])
  expect(brow).toMatchObject({ area: 'brow', activation: expect.closeTo(0.6, 6), resting: 0 })
  expect(types(brow.parts)).toEqual([
    ['morph', expect.closeTo(0.3, 6)],
    ['tension', expect.closeTo(0.3, 6)],
  ])
  expect(brow.parts[0].links[0]).toMatchObject({
    link: { name: 'browDownLeft' },
    value: expect.closeTo(0.3, 6),
  })
  expect(nose).toMatchObject({ activation: expect.closeTo(0.5, 6), resting: expect.closeTo(0.2, 6) })
  expect(types(nose.parts)).toEqual([['age', expect.closeTo(0.3, 6)]])
  // The driver of the neck gives more, but the delay slows its activation.
  expect(neck.activation).toBeLessThan(0.2)
  expect(types(neck.parts)).toEqual([['bone', expect.closeTo(0.4, 6)]])
})

it('lists no drivers while the application activates the areas itself', () => {
  const { wrinkles, activations } = drivenFace([morph('brow', 'browDownLeft')])
  activations()
  wrinkles.driven = false
  wrinkles.setActivation('brow', 0.7)
  expect(wrinkles.explain()[0]).toEqual({
    area: 'brow',
    activation: expect.closeTo(0.7, 6),
    resting: 0,
    parts: [],
  })
  expect(() => wrinkles.explain(1)).toThrow(/Wrinkles.explain: .*instance/)
})
