import fc from 'fast-check'
import { fileNamesOf, isFileName } from 'furrow/internal'
import { describe, expect, it } from 'vitest'

describe('fileNamesOf', () => {
  it('keeps a name that every file system accepts', () => {
    const names = ['foreheadLeft', 'brow 2 #1', 'v1.2', '額', 'a%20b', "artist's", '-x']
    expect(fileNamesOf(names)).toEqual(names)
    expect(names.every(isFileName)).toBe(true)
  })

  it.each([
    ['a/b\\c', 'a_b_c'],
    ['..', '_'],
    ['.hidden', '_hidden'],
    ['ends with a dot.', 'ends with a dot_'],
    ['CON', 'CON_'],
    ['nul.left', 'nul_.left'],
    ['a\u202eb', 'a_b'],
    ['what?', 'what_'],
    ['e\u0301', '\u00e9'],
  ])('makes %j a file name', (name, expected) => {
    expect(fileNamesOf([name])).toEqual([expected])
  })

  it('cuts a long name between characters', () => {
    const [name] = fileNamesOf(['額'.repeat(256)])
    expect(name).toBe('額'.repeat(33))
  })

  it('makes different file names for names that some file systems consider equal', () => {
    expect(fileNamesOf(['Brow', 'brow', 'brow-2', 'caf\u00e9', 'cafe\u0301', 'straße', 'STRASSE'])).toEqual([
      'Brow',
      'brow-3',
      'brow-2',
      'caf\u00e9',
      'caf\u00e9-2',
      'straße',
      'STRASSE-2',
    ])
  })

  it('keeps an existing name', () => {
    expect(fileNamesOf(['a/b', 'a_b'])).toEqual(['a_b-2', 'a_b'])
  })

  it('makes different and valid file names of any names', () => {
    const character = fc.oneof(fc.constantFrom(...'aA.:/ -_2\u0301\u200d'), fc.string({ unit: 'binary' }))
    const name = fc.array(character, { minLength: 1, maxLength: 120 }).map((parts) => parts.join(''))
    fc.assert(
      fc.property(fc.uniqueArray(name.filter(Boolean), { maxLength: 20 }), (names) => {
        const files = fileNamesOf(names)
        expect(new Set(files.map((file) => file.normalize('NFKC').toLowerCase())).size).toBe(names.length)
        for (const file of files) {
          expect(Buffer.byteLength(file)).toBeLessThan(110)
          // biome-ignore lint/suspicious/noControlCharactersInRegex: the characters to exclude.
          expect(/[<>:"/\\|?*\x00-\x1f\x7f]|^[ .]|[ .]$|^$/.test(file), JSON.stringify(file)).toBe(false)
        }
      }),
      { numRuns: 100, seed: 8 },
    )
  })
})
