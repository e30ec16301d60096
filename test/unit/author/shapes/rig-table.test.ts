import { resolve } from 'node:path'
import { expect, test } from 'vitest'
import { readTable } from '../../../../scripts/lib/marked-table.mjs'
import { HEAD, ROWS, readFace, rowOf } from '../../../rigs/rig-table.ts'

const table = readTable('docs/auto-formats.md', 'rigs')

test('the table has a row for each rig', () => {
  expect(table.slice(0, 2), 'out of date: npm run rig-table').toEqual(HEAD)
  const rigs = table.slice(2).map((line) => line.split(' | ')[0]!.slice(2))
  expect(rigs, 'out of date: npm run rig-table').toEqual(Object.keys(ROWS))
})

test('a face with meaningless names has the areas listed in the table', async () => {
  const row = rowOf('no names', await readFace(resolve('.')))
  expect(table, 'out of date: npm run rig-table').toContain(row)
})
