import { readdirSync, readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { expect, test } from 'vitest'

/** The rooms of `author/auto`, in the direction of the data: each imports only from those before it. */
const ROOMS = ['surface', 'anatomy', 'strain', 'lines', 'fit', 'raster', 'blood', 'furrows']
const AUTO = fileURLToPath(new URL('../../../../packages/furrow/src/author/auto/', import.meta.url))

test.each(ROOMS)('%s imports from earlier rooms only', (room) => {
  const later = ROOMS.slice(ROOMS.indexOf(room) + 1)
  const files = readdirSync(`${AUTO}${room}`)
  expect(files.length).toBeGreaterThan(0)
  for (const file of files) {
    const text = readFileSync(`${AUTO}${room}/${file}`, 'utf8')
    const imported = [...text.matchAll(/from '\.\.\/([\w-]+)\/[\w-]+\.ts'/g)].map(([, name]) => name)
    expect(
      imported.filter((name) => later.includes(name)),
      file,
    ).toEqual([])
    expect(text, file).not.toMatch(/from '\.\.\/[\w-]+\.ts'/)
  }
})
