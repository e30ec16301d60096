import { isName } from 'furrow/internal'
import { describe, expect, it } from 'vitest'

describe('isName', () => {
  it.each([
    ['a letter', 'a'],
    ['spaces and punctuation', ' left brow, #2 (50%) '],
    ['a path', '../areas/a\\b:c'],
    ['a device', 'CON'],
    ['256 letters outside the basic plane', '𝒜'.repeat(256)],
    ['another script', '額のしわ'],
  ])('accepts %s', (_, name) => {
    expect(isName(name)).toBe(true)
  })

  it.each([
    ['nothing', ''],
    ['no text', 3],
    ['257 letters', 'a'.repeat(257)],
    ['a line break', 'a\nb'],
    ['a NUL', 'a\0'],
    ['a terminal escape', '\u001b[2J'],
    ['a C1 control character', '\u009b2J'],
    ['a line separator', 'a\u2028b'],
    ['half of a surrogate pair', 'a\ud800'],
  ])('refuses %s', (_, name) => {
    expect(isName(name)).toBe(false)
  })
})
