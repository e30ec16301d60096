import { readdirSync, readFileSync } from 'node:fs'
import { dirname, join, relative, resolve } from 'node:path'
import { fileURLToPath } from 'node:url'
import { describe, expect, it } from 'vitest'

const ROOT = fileURLToPath(new URL('../../', import.meta.url))
const SOURCES = join(ROOT, 'packages/furrow/src')

/** A file of the library and what it imports: files by their paths in `src`, packages by their names. */
interface Source {
  path: string
  imports: string[]
}

const sources: Source[] = readdirSync(SOURCES, { recursive: true, encoding: 'utf8' })
  .filter((path) => path.endsWith('.ts'))
  .map((path) => ({ path, imports: importsOf(path) }))

function importsOf(path: string): string[] {
  const text = readFileSync(join(SOURCES, path), 'utf8')
  const specifiers = [...text.matchAll(/(?:from|import)\s*\(?\s*'([^']+)'/g)].map(
    ([, specifier]) => specifier,
  )
  return specifiers.map((specifier) =>
    specifier.startsWith('.')
      ? relative(SOURCES, resolve(SOURCES, dirname(path), specifier))
      : specifier.replace(/^((?:@[^/]+\/)?[^/]+).*$/, '$1'),
  )
}

/** Rows of CONTRIBUTING's table: each room, and the rooms and packages it may import. */
function allowedImports(): Map<string, string[]> {
  const page = readFileSync(join(ROOT, 'CONTRIBUTING.md'), 'utf8')
  const rows = page.matchAll(/^\| `packages\/furrow\/src\/([\w/]+)` \| [^|]+ \| ([^|]+) \|$/gm)
  return new Map(
    [...rows].map(([, room, imports]) => [room, [...imports.matchAll(/`([^`]+)`/g)].map(([, name]) => name)]),
  )
}

const allowed = allowedImports()

/** The room of a file: the deepest folder that the table names. Entries of the package belong to none. */
function roomOf(path: string): string | undefined {
  if (!path.includes('/') || path === 'three/index.ts') return undefined
  const rooms = [...allowed.keys()].filter((room) => path.startsWith(`${room}/`))
  return rooms.sort((a, b) => b.length - a.length)[0]
}

/** Rooms within a room, in the direction of the data: each imports only from those before it, and of the folder itself what is shared. */
const WITHIN = [
  {
    folder: 'author/auto',
    rooms: ['surface', 'anatomy', 'strain', 'lines', 'fit', 'raster', 'blood', 'furrows'],
    shared: [],
  },
  {
    folder: 'three/webgl',
    rooms: ['patch', 'influence', 'mixing', 'modes', 'relief'],
    shared: ['uniforms.ts'],
  },
  {
    folder: 'three/webgpu',
    rooms: ['patch', 'influence', 'mixing', 'modes', 'relief', 'compute'],
    shared: ['newer-nodes.ts', 'node.ts', 'texture-sampling.ts'],
  },
]

describe('the rooms of the library', () => {
  it('are all in the table of CONTRIBUTING', () => {
    const folders = readdirSync(SOURCES, { withFileTypes: true }).filter((entry) => entry.isDirectory())
    for (const { name } of folders) expect([...allowed.keys()]).toContain(name)
  })

  it.each([...allowed])('%s imports %j and itself only', (room, others) => {
    const files = sources.filter(({ path }) => roomOf(path) === room)
    expect(files.length).toBeGreaterThan(0)
    const wrong = files.flatMap(({ path, imports }) =>
      imports
        .filter((name) => {
          const other = name.endsWith('.ts') ? roomOf(name) : name
          return other !== room && !others.includes(other ?? '')
        })
        .map((name) => `${path} imports ${name}`),
    )
    expect(wrong).toEqual([])
  })

  it.each(WITHIN)('those of $folder import earlier ones only', ({ folder, rooms, shared }) => {
    const folders = readdirSync(join(SOURCES, folder), { withFileTypes: true })
    expect(folders.filter((entry) => entry.isDirectory()).map(({ name }) => name)).toEqual([...rooms].sort())
    rooms.forEach((room, index) => {
      const may = [...rooms.slice(0, index + 1).map((name) => `${name}/`), ...shared]
      const files = sources.filter(({ path }) => path.startsWith(`${folder}/${room}/`))
      const wrong = files.flatMap(({ path, imports }) =>
        imports
          .filter((name) => name.startsWith(`${folder}/`))
          .filter((name) => !may.some((start) => name.startsWith(`${folder}/${start}`)))
          .map((name) => `${path} imports ${name}`),
      )
      expect(wrong).toEqual([])
    })
  })

  it('have no circle of imports, those of types included', () => {
    const byPath = new Map(sources.map(({ path, imports }) => [path, imports]))
    const done = new Set<string>()
    const circles: string[] = []
    const visit = (path: string, trail: readonly string[]) => {
      const start = trail.indexOf(path)
      if (start >= 0) circles.push([...trail.slice(start), path].join(' -> '))
      if (start >= 0 || done.has(path)) return
      for (const next of byPath.get(path) ?? []) visit(next, [...trail, path])
      done.add(path)
    }
    for (const path of byPath.keys()) visit(path, [])
    expect(circles).toEqual([])
  })
})
