import { signal } from '@preact/signals'
import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import { Hints } from '../../../../studio/src/first/hints.ts'

/** Storage of a browser. */
function storage(): Pick<Storage, 'getItem' | 'setItem'> {
  const items = new Map<string, string>()
  return {
    getItem: (key) => items.get(key) ?? null,
    setItem: (key, text) => void items.set(key, text),
  }
}

beforeEach(() => void vi.stubGlobal('localStorage', storage()))
afterEach(() => void vi.unstubAllGlobals())

function hints() {
  const parts = {
    isSelected: signal(false),
    undoLabel: signal<string | undefined>(undefined),
    expression: signal<string | null>('surprised'),
  }
  return { ...parts, hints: new Hints(parts) }
}

test('each hint disappears when the user has done what it says', () => {
  const { isSelected, undoLabel, expression, hints: all } = hints()
  expect(all.shown.value).toBeNull()
  all.start()
  expect(all.shown.value).toBe('click')
  expression.value = 'happy'
  expect(all.shown.value).toBe('click')
  isSelected.value = true
  expect(all.shown.value).toBe('drag')
  undoLabel.value = 'Depth of a line'
  expect(all.shown.value).toBe('keys')
  expression.value = 'angry'
  expect(all.shown.value).toBeNull()
})

test('the hints do not return after they were followed or dismissed', () => {
  const { hints: first } = hints()
  first.start()
  first.dismiss()
  expect(first.shown.value).toBeNull()
  const { hints: second } = hints()
  second.start()
  expect(second.shown.value).toBeNull()
})

test('a browser that denies storage shows the hints', () => {
  const denied = () => {
    throw new DOMException('denied', 'SecurityError')
  }
  vi.stubGlobal('localStorage', { getItem: denied, setItem: denied })
  const { hints: all } = hints()
  all.start()
  expect(all.shown.value).toBe('click')
  all.dismiss()
  expect(all.shown.value).toBeNull()
})
