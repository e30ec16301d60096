import { describe, expect, it } from 'vitest'
import { closure, compressed } from '../../bench/size.mjs'
import { compare, readFigures, sizeTable, warnings } from '../../scripts/lib/download.mjs'
import { readTable } from '../../scripts/lib/marked-table.mjs'

describe('the check of download sizes', () => {
  const size = (gzip: number) => ({ gzip, brotli: gzip - 10 })
  const warningsOf = (now: number, before: number) =>
    warnings(compare({ 'the loader': size(now) }, { 'the loader': size(before) }))

  it('warns about growth by more than 2%, with both numbers', () => {
    expect(warningsOf(1021, 1000)).toEqual([
      expect.stringContaining('the loader has grown by 2.1%, from 1000 to 1021 bytes'),
    ])
  })

  it('ignores smaller growth, decreases and new entries', () => {
    expect(warningsOf(1020, 1000)).toEqual([])
    expect(warningsOf(500, 1000)).toEqual([])
    expect(warnings(compare({ new: size(5) }, {}))).toEqual([])
  })
})

describe('the size of a page', () => {
  const chunks = [
    { fileName: 'page', imports: ['shared', 'three'], code: 'a' },
    { fileName: 'shared', imports: ['deep'], code: 'b' },
    { fileName: 'deep', imports: ['shared'], code: 'c' },
    { fileName: 'later', imports: ['page'], code: 'd' },
  ]

  it('is the sum of all files loaded at once', () => {
    const own = closure([chunks[0]], chunks)
    expect(own.map(({ fileName }) => fileName)).toEqual(['page', 'shared', 'deep'])
    expect(compressed(own).gzip).toBe(3 * compressed([chunks[0]]).gzip)
  })
})

it('docs/download.md has the current sizes', () => {
  expect(readTable('docs/download.md', 'sizes')).toEqual(sizeTable(readFigures()))
})
