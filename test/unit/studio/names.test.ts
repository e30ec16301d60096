import { describe, expect, it } from 'vitest'
import {
  changed,
  checkNewName,
  findNamed,
  freeName,
  kept,
  replaceNamed,
} from '../../../studio/src/document/names.ts'

const items = ['brow', 'brow 2', 'nose'].map((name) => ({ name }))

describe('names', () => {
  it('find their item, or throw an error that lists the existing names', () => {
    expect(findNamed(items, 'nose', 'area')).toBe(items[2])
    expect(() => findNamed(items, 'chin', 'area')).toThrow(
      'Studio: no such area, got "chin", allowed: brow, brow 2, nose; name one of these',
    )
    expect(() => findNamed([], 'chin', 'area')).toThrow('allowed: none; add one first')
  })

  it('replace the item with that name and keep the others', () => {
    const after = replaceNamed(items, 'brow', 'area', () => ({ name: 'chin' }))
    expect(after).toEqual([{ name: 'chin' }, items[1], items[2]])
    expect(after[1]).toBe(items[1])
  })

  it('must be valid and not taken if they are new', () => {
    expect(() => checkNewName(items, 'chin', 'area')).not.toThrow()
    expect(() => checkNewName(items, 'nose', 'area')).toThrow(
      'another area already has this name, got "nose"',
    )
    expect(() => checkNewName(items, '\u2028', 'area')).toThrow('no usable name')
  })

  it('are numbered if taken', () => {
    expect(freeName(items, 'chin')).toBe('chin')
    expect(freeName(items, 'nose')).toBe('nose 2')
    expect(freeName(items, 'brow')).toBe('brow 3')
    expect(freeName(items, 'brow 2')).toBe('brow 3')
  })
})

describe('lists', () => {
  it('stay the same array if nothing in them changes', () => {
    expect(changed(items, (item) => item)).toBe(items)
    expect(kept(items, () => true)).toBe(items)
    expect(changed(items, (item) => (item.name === 'nose' ? { name: 'chin' } : item))[0]).toBe(items[0])
    expect(kept(items, ({ name }) => name !== 'nose')).toEqual(items.slice(0, 2))
  })
})
