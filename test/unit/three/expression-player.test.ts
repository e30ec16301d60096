import type { Expression } from 'furrow'
import { ExpressionPlayer, Wrinkles } from 'furrow/three'
import { expect, it, vi } from 'vitest'
import { blendMesh } from '../../blend-mesh.ts'
import { face, set } from './refused.ts'

const EXPRESSIONS: Expression[] = [
  { name: 'neutral', targets: {}, activations: {} },
  { name: 'shout', targets: { jawOpen: 1 }, activations: { area0: 1 } },
]

it('starts from the current state of the face, even if it was changed by other means', () => {
  const { mesh, wrinkles } = face()
  const player = new ExpressionPlayer(mesh, wrinkles, EXPRESSIONS)
  mesh.morphTargetInfluences![0] = 0.8
  wrinkles.setActivation('area0', 0.6)
  player.play('neutral', 1)
  player.update(0.5)
  expect(mesh.morphTargetInfluences![0]).toBeCloseTo(0.4, 6)
  expect(wrinkles.getActivation('area0')).toBeCloseTo(0.3, 6)
})

it('does not change the face after the transition', () => {
  const { mesh, wrinkles } = face()
  const player = new ExpressionPlayer(mesh, wrinkles, EXPRESSIONS)
  player.play('shout', 0)
  mesh.morphTargetInfluences![0] = 0.2
  player.update(1)
  expect(mesh.morphTargetInfluences![0]).toBe(0.2)
})

it('measures the time itself if it is given none', () => {
  const now = vi.spyOn(performance, 'now').mockReturnValue(5000)
  const { mesh, wrinkles } = face()
  const player = new ExpressionPlayer(mesh, wrinkles, EXPRESSIONS)
  player.play('shout', 1)
  for (const [time, expected] of [
    [5250, 0.25],
    [5500, 0.5],
    [9000, 1],
  ]) {
    now.mockReturnValue(time)
    player.update()
    expect(mesh.morphTargetInfluences![0]).toBeCloseTo(expected, 6)
  }
  now.mockRestore()
})

it('lists the expressions that the face can show, and does nothing for others', () => {
  const mesh = blendMesh('Fcl_ALL_Angry', 'viseme_aa')
  const player = new ExpressionPlayer(mesh, undefined)
  expect(player.expressionNames).toEqual(['neutral', 'angry'])
  player.play('disgusted', 0)
  expect(mesh.morphTargetInfluences).toEqual([0, 0])
  player.play('angry', 0)
  expect(mesh.morphTargetInfluences).toEqual([1, 0])
})

it('moves a face without wrinkles', () => {
  const mesh = blendMesh('jawOpen')
  const player = new ExpressionPlayer(mesh, undefined, EXPRESSIONS)
  player.play('shout', 0)
  expect(mesh.morphTargetInfluences).toEqual([1])
})

it('sets areas that an expression does not name to their resting activations', () => {
  const mesh = blendMesh('jawOpen')
  const { areas, layers } = set()
  const scarred = areas.map((area, i) => (i === 0 ? { ...area, activation: 0.75 } : area))
  const wrinkles = new Wrinkles(mesh, { layers, areas: scarred })
  const player = new ExpressionPlayer(mesh, wrinkles, EXPRESSIONS)
  player.play('shout', 0)
  expect(wrinkles.getActivation('area0')).toBe(1)
  player.play('neutral', 0)
  expect(wrinkles.getActivation('area0')).toBe(0.75)
})
