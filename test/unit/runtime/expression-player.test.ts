import type { WrinkleDriver } from 'furrow'
import { ExpressionPlayer } from 'furrow/three'
import { describe, expect, it } from 'vitest'
import { morph, ramp } from '../../drivers.ts'
import { drivenFace } from '../three/driven-face.ts'

describe.each<[string, WrinkleDriver]>([
  ['a blendshape', morph('brow', 'browDownLeft')],
  ['age', { type: 'age', area: 'brow', curve: ramp(20, 70) }],
])('while the driver of %s is off, a transition', (_, driver) => {
  /** Turns the drivers off at an activation of 0.5. */
  function stopped() {
    const { mesh, wrinkles, activations } = drivenFace([driver])
    mesh.morphTargetInfluences![0] = 0.5
    wrinkles.inputs.set('age', 45)
    expect(activations()[0]).toBe(0.5)
    wrinkles.driven = false
    const player = new ExpressionPlayer(mesh, wrinkles, [
      { name: 'rest', targets: {}, activations: {} },
      { name: 'frown', targets: {}, activations: { brow: 1 } },
    ])
    return { wrinkles, player }
  }

  it('starts from the last activation of the driver', () => {
    const { wrinkles, player } = stopped()
    player.play('frown', 1)
    player.update(0.5)
    expect(wrinkles.getActivation('brow')).toBeCloseTo(0.75, 6)
  })

  it('starts from the activation of the last transition', () => {
    const { wrinkles, player } = stopped()
    player.play('frown', 0)
    player.play('frown', 1)
    player.update(0.01)
    expect(wrinkles.getActivation('brow')).toBe(1)
    player.play('rest', 1)
    player.update(0.25)
    expect(wrinkles.getActivation('brow')).toBeCloseTo(0.75, 6)
  })
})
