import { describe, expect, it } from 'vitest'
import { type Scope, SHORTCUTS, shortcutOf } from '../../../studio/src/shortcuts.ts'

/** Key event as the browser reports it. */
function press(
  key: string,
  ...modifiers: ('Control' | 'Meta' | 'Shift' | 'Alt' | 'AltGraph')[]
): KeyboardEvent {
  const has = (name: string) => modifiers.includes(name as never)
  return {
    key,
    ctrlKey: has('Control'),
    metaKey: has('Meta'),
    shiftKey: has('Shift'),
    altKey: has('Alt'),
    getModifierState: has,
    target: null,
  } as unknown as KeyboardEvent
}

describe('a key', () => {
  it.each([
    ['undoes', press('z', 'Control'), 'undo'],
    ['undoes on a Mac', press('z', 'Meta'), 'undo'],
    ['redoes, with Shift, which makes it a capital', press('Z', 'Control', 'Shift'), 'redo'],
    ['redoes by another key', press('y', 'Control'), 'redo'],
    ['is a question mark, however it is typed', press('?', 'Shift'), 'list'],
    ['is only a letter', press('z'), undefined],
    ['is another shortcut with Alt', press('z', 'Control', 'Alt'), undefined],
  ])('%s', (_, event, name) => {
    expect(shortcutOf('everywhere', event)).toBe(name)
  })

  it('moves the divider farther with Shift', () => {
    expect(shortcutOf('divider', press('ArrowLeft'))).toBe('left')
    expect(shortcutOf('divider', press('ArrowLeft', 'Shift'))).toBe('farLeft')
  })

  it('for a bracket also works on keyboards where it needs AltGr', () => {
    expect(shortcutOf('painting', press('['))).toBe('smaller')
    expect(shortcutOf('painting', press('[', 'Control', 'Alt', 'AltGraph'))).toBe('smaller')
    expect(shortcutOf('painting', press('X', 'Shift'))).toBe('swap')
  })
})

it('a key has only one meaning in each part of the page', () => {
  for (const scope of Object.keys(SHORTCUTS) as Scope[]) {
    const keys = Object.values<readonly string[]>(SHORTCUTS[scope]).flat()
    expect(new Set(keys).size).toBe(keys.length)
  }
})
