import { parseDrivers } from 'furrow'
import {
  activationTrack,
  addArea,
  addDrivers,
  ExpressionPlayer,
  removeArea,
  updateArea,
  updateLayer,
  Wrinkles,
} from 'furrow/three'
import { AnimationClip, AnimationMixer, type MeshStandardMaterial } from 'three'
import { describe, expect, it } from 'vitest'
import { STRAIGHT } from '../../drivers.ts'
import { expectRefused, face, plain, set } from './refused.ts'
import { frameOf } from './stub-renderer.ts'

describe('after dispose', () => {
  const { mesh, wrinkles } = face()
  wrinkles.dispose()
  const gone = /the wrinkles have been disposed; create new wrinkles for the mesh$/
  const calls: [string, () => unknown][] = [
    ['setActivation', () => wrinkles.setActivation('area0', 1)],
    ['setActivations', () => wrinkles.setActivations(['area0'], Float32Array.of(1))],
    ['setRestingActivation', () => wrinkles.setRestingActivation('area0', 1)],
    [
      'mode',
      () => {
        wrinkles.mode = 'composed'
      },
    ],
    ['addArea', () => addArea(wrinkles, { ...set().areas[0], name: 'b' })],
    ['removeArea', () => removeArea(wrinkles, 'area0')],
    ['inputs.set', () => wrinkles.inputs.set('age', 40)],
    ['addMesh', () => wrinkles.addMesh(mesh)],
    ['update', () => wrinkles.update()],
    ['explain', () => wrinkles.explain()],
    ['createInfluenceMaterial', () => wrinkles.createInfluenceMaterial()],
    ['cloneMaterial', () => wrinkles.cloneMaterial()],
    ['addDrivers', () => addDrivers(wrinkles, [])],
    ['updateArea', () => updateArea(wrinkles, 'area0', set().areas[0].weights)],
    ['updateLayer', () => updateLayer(wrinkles, 'skin', { normal: set().layers[0].normal })],
    ['wrinkles of another mesh made from them', () => new Wrinkles(plain(), wrinkles)],
  ]

  it.each(calls)('%s is refused', (_, run) => {
    expectRefused(run, gone)
    expect((mesh.material as MeshStandardMaterial).normalMap).toBeNull()
  })

  it('a second dispose does nothing, and does not affect other faces', () => {
    const other = face()
    const draw = frameOf(other.mesh)
    draw()
    wrinkles.dispose()
    addDrivers(
      other.wrinkles,
      parseDrivers([{ type: 'input', area: 'area0', name: 'snow', curve: STRAIGHT }], ['area0']),
    )
    other.wrinkles.inputs.set('snow', 1)
    draw()
    draw()
    expect(other.wrinkles.getActivation('area0')).toBe(1)
  })

  it('expressions and animations still move the face', () => {
    const { mesh, wrinkles } = face()
    const shout = { name: 'shout', targets: { jawOpen: 1 }, activations: { area0: 1 } }
    const player = new ExpressionPlayer(mesh, wrinkles, [shout])
    const mixer = new AnimationMixer(mesh)
    mixer.clipAction(new AnimationClip('a', 1, [activationTrack(mesh, 'area0', [0, 1], [0, 1])])).play()
    mixer.update(0.1)
    wrinkles.dispose()
    player.play('shout', 1)
    player.update(0.5)
    mixer.update(0.5)
    expect(mesh.morphTargetInfluences).toEqual([0.5])
    frameOf(mesh)()
  })
})
