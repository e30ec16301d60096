import { existsSync, readFileSync } from 'node:fs'
import { resolve } from 'node:path'
import { fileURLToPath } from 'node:url'
import { describe, expect, it } from 'vitest'

const DOCS = fileURLToPath(new URL('../../docs/', import.meta.url))
const page = readFileSync(`${DOCS}paper.md`, 'utf8')

/** Returns the rows, as cells, of all tables whose last columns are `code` and `test`. */
function rows(): string[][] {
  const tables = page.match(/(?:^\|.*\|\n)+/gm) ?? []
  return tables
    .filter((table) => table.split('\n')[0].endsWith('| code | test |'))
    .flatMap((table) => table.trim().split('\n').slice(2))
    .map((row) => row.slice(2, -2).split(' | '))
}

const linksOf = (cell: string) => [...cell.matchAll(/\]\(([^)#]+)\)/g)].map(([, link]) => link)

describe('the paper, point by point', () => {
  it('has a row for each statement, figure, table and system', () => {
    expect(rows().length).toBeGreaterThan(40)
    for (const name of ['Figure 8', 'Figure 9', 'Figure 10', 'Table 1', 'Table 2']) {
      expect(rows().map(([first]) => first.split(':')[0])).toContain(name)
    }
    for (const work of ['Bando', 'Wang', 'Li', 'Boissieux', 'Nordenberg', 'Loviscach', 'Tu']) {
      expect(rows().some(([first]) => first.startsWith(`${work} 200`))).toBe(true)
    }
  })

  it.each(rows().map((row) => [row[0], row.at(-2)!, row.at(-1)!]))(
    '%s: code and test exist',
    (_, code, test) => {
      expect(linksOf(code)).not.toEqual([])
      expect(linksOf(test)).not.toEqual([])
      for (const link of [...linksOf(code), ...linksOf(test)])
        expect(existsSync(resolve(DOCS, link)), link).toBe(true)
      for (const link of linksOf(code)) expect(link).not.toMatch(/\/test\//)
      for (const link of linksOf(test)) expect(link).toMatch(/^\.\.\/test\/.+\.test\.ts$/)
    },
  )
})
