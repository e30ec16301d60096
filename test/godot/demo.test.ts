import { EXPRESSIONS } from 'furrow'
import { expect, it } from 'vitest'
import { godot } from './harness.ts'
import { command } from './start-godot.ts'

const harness = godot()

it('the demo has a slider per expression, which moves the face', async () => {
  const names = EXPRESSIONS.map(({ name }) => name).filter((name) => name !== 'neutral')
  const show = (expression: string) => command<{ sliders: string[]; png: string }>('demo', { expression })
  const rest = await show('')
  expect(rest.sliders).toEqual(names)
  const surprised = await show('surprised')
  expect(surprised.png).not.toBe(rest.png)
  // Godot itself complains about sparse accessors with padding, but reads them.
  expect(harness.messages.filter((text) => /furrow|res:/i.test(text))).toEqual([])
})
