import { expect, it } from 'vitest'
import { MessageList } from '../../../studio/src/message-list.ts'

function listOf(...texts: string[]): MessageList {
  const list = new MessageList()
  for (const text of texts) list.add(text)
  return list
}

const shownBy = (list: MessageList) => list.shown.map(({ text }) => text)

it('more than two errors are folded, the newest ones stay', () => {
  const list = listOf('a', 'b', 'c', 'd')
  expect([shownBy(list), list.folded]).toEqual([['c', 'd'], 2])
  list.unfold()
  expect([shownBy(list), list.folded]).toEqual([['a', 'b', 'c', 'd'], 0])
})

it('a dismissed error makes room for an older one', () => {
  const list = listOf('a', 'b', 'c')
  list.remove(list.messages.slice(-1))
  expect([shownBy(list), list.folded]).toEqual([['a', 'b'], 0])
})

it('an error that occurs again is shown once, as the newest', () => {
  expect(shownBy(listOf('a', 'b', 'a'))).toEqual(['b', 'a'])
})

it('errors that were added later stay when older ones are removed', () => {
  const list = listOf('a', 'b')
  const { messages } = list
  list.add('c')
  list.add('a')
  list.remove(messages)
  expect(shownBy(list)).toEqual(['c', 'a'])
})

it('an empty list is folded again', () => {
  const list = listOf('a', 'b', 'c')
  list.unfold()
  list.remove(list.messages)
  for (const text of ['a', 'b', 'c']) list.add(text)
  expect(list.folded).toBe(1)
})
