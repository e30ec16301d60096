import { resolve } from 'node:path'
import type { Skin } from 'furrow/author'
import { beforeAll, describe, expect, test } from 'vitest'
import { readTable } from '../../../../scripts/lib/marked-table.mjs'
import { ROWS, readFace, rowOf } from '../../../rigs/rig-table.ts'

const table = readTable('docs/auto-formats.md', 'rigs')
let face: Skin

beforeAll(async () => {
  face = await readFace(resolve('.'))
})

describe('a face has the areas listed for its rig', () => {
  test.each(Object.keys(ROWS))('%s', (name) => {
    expect(table, 'out of date: npm run rig-table').toContain(rowOf(name, face))
  })
})
