import { type Expression, parseDrivers } from 'furrow'
import { expect, it } from 'vitest'
import { expressionsShowing, performanceOf } from '../../../../studio/src/viewer/pose/performance.ts'

const TARGETS = ['brow_up', 'browDown', 'jawOpen', 'cheek']
const drivers = parseDrivers(
  [
    { type: 'morph', area: 'forehead', targets: [{ name: 'brow_up' }] },
    { type: 'morph', area: 'frown', targets: [{ name: 'browDown' }, { name: 'brow_up', weight: -1 }] },
    { type: 'morph', area: 'cheeks', targets: [{ name: 'cheek' }] },
    { type: 'area', area: 'both', areas: [{ name: 'forehead' }] },
  ],
  ['forehead', 'frown', 'cheeks', 'both', 'chin', 'lines'],
)
const expressionOf = (name: string, targets: Record<string, number>, activations = {}): Expression => ({
  name,
  targets,
  activations,
})
const expressions = [
  expressionOf('neutral', { brow_up: 0, browDown: 0, jawOpen: 0, cheek: 0 }),
  expressionOf('afraid', { brow_up: 0.6, jawOpen: 0.3 }),
  expressionOf('surprised', { brow_up: 0.9, jawOpen: 0.5 }),
  expressionOf('angry', { browDown: 0.8 }, { chin: 0.7 }),
]
const perform = (area: string) => performanceOf(area, drivers, expressions, TARGETS)
const targetsOf = (area: string) => Object.fromEntries(perform(area)?.targets ?? [])

it('the expression that shows an area is the one that drives it most, also through other areas', () => {
  expect(targetsOf('forehead')).toEqual({ brow_up: 0.9, jawOpen: 0.5 })
  expect(targetsOf('both')).toEqual({ brow_up: 0.9, jawOpen: 0.5 })
  expect(targetsOf('frown')).toEqual({ browDown: 0.8 })
})

it('the expressions that show an area are those that drive it visibly, the strongest first', () => {
  const shown = (area: string) =>
    expressionsShowing(area, drivers, [...expressions, expressionOf('calm', { brow_up: 0.15 })], TARGETS).map(
      ({ name, activation }) => [name, Number(activation.toFixed(2))],
    )
  expect(shown('forehead')).toEqual([
    ['surprised', 0.9],
    ['afraid', 0.6],
  ])
  expect(shown('chin')).toEqual([['angry', 0.7]])
  expect(shown('cheeks')).toEqual([])
})

it('the expression that shows an area may activate the area itself', () => {
  expect(perform('chin')?.activations.get('chin')).toBe(0.7)
})

it('the blendshapes of its drivers show an area at full weight if no expression does', () => {
  expect(targetsOf('cheeks')).toEqual({ cheek: 1 })
})

it('nothing shows an area that no blendshape moves', () => {
  expect(perform('lines')).toBeNull()
})
