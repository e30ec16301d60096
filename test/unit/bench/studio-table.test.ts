import { expect, it } from 'vitest'
import { type Result, toTable } from '../../../bench/studio/table.ts'

it('has a row per figure, with the goal that belongs to the start of its name', () => {
  const rows: Result[] = [
    {
      figure: 'stroke to heights: 500 lines',
      medians: { before: { submitted: 2200.4, seen: 3000 }, now: { submitted: 59.4, seen: 968 } },
    },
    { figure: 'dab', medians: { now: { submitted: 9.04 } } },
  ]
  expect(toTable(rows, ['before', 'now']).split('\n')).toEqual([
    '| figure | before | drawn | now | drawn | goal |',
    '| --- | --- | --- | --- | --- | --- |',
    '| stroke to heights: 500 lines | 2,200 | 3,000 | 59 | 968 | 100 |',
    '| dab |  |  | 9.0 |  |  |',
    '',
  ])
})
