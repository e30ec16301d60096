import { h } from 'preact'
import { expect, test } from 'vitest'
import '../../../studio/src/ui/change-events.ts'

test.each(['range', 'text', 'checkbox'])('an input of type %s keeps `change` apart from `input`', (type) => {
  const [onInput, onChange] = [() => {}, () => {}]
  const { props } = h('input', { type, onInput, onChange })
  expect(props).toMatchObject({ oninput: onInput, onChangeCapture: onChange })
  expect(Object.keys(props).filter((name) => /input/i.test(name))).toEqual(['oninput'])
})

test('components receive `onChange` unchanged', () => {
  const onChange = () => {}
  const Field = () => null
  expect(h(Field as () => null, { onChange } as object).props).toEqual({ onChange })
})
