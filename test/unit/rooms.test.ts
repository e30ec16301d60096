import { readdirSync, readFileSync } from 'node:fs'
import { dirname, join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { describe, expect, it } from 'vitest'
import { readImports } from '../../scripts/lib/imports.mjs'
import { drawRooms } from '../../scripts/lib/room-graph.mjs'

const ROOT = fileURLToPath(new URL('../../', import.meta.url))
const LIBRARY = 'packages/furrow/src'

/** Folders whose subfolders are rooms. A room has a list of allowed imports. Files outside rooms are entry points and may import any room. */
const HOMES = [LIBRARY, 'packages/files/src', 'packages/cli/src', 'studio/src', 'stage']

/** Entry point that only this repository uses. It may import any room. */
const INTERNAL = 'packages/furrow/internal'

/** Folders with code. No imports in them may be circular. */
const CODE = ['packages', 'studio', 'stage', 'bench', 'conformance', 'examples', 'site', 'scripts', 'test']

const readJson = (path: string) => JSON.parse(readFileSync(join(ROOT, path), 'utf8'))
const PUBLIC = Object.keys(readJson('packages/furrow/package.json').exports).map(
  (entry) => `furrow${entry.slice(1)}`,
)
const PLATFORMS: Record<string, Record<string, string>> = readJson('packages/files/package.json').imports

/** All source files with their imports. An import that differs between Node and browsers counts as both. */
const sources = readImports(CODE).map(({ path, imports }) => ({
  path,
  imports: imports.flatMap((name) => {
    const files = name.startsWith('#') ? Object.values(PLATFORMS[name] ?? {}) : []
    return files.length > 0 ? files.map((file) => join('packages/files', file)) : name
  }),
}))
const importsOf = new Map(sources.map(({ path, imports }) => [path, imports]))

const homeOf = (path: string) => HOMES.find((home) => path.startsWith(`${home}/`))

/** Reads the tables of docs/architecture.md. Returns, by room, the rooms and packages that it may import. */
function allowedImports(): Map<string, string[]> {
  const page = readFileSync(join(ROOT, 'docs/architecture.md'), 'utf8')
  const rows = page.matchAll(/^\| `((?:packages\/|studio\/|stage)[\w/]*)` \| [^|]+ \| ([^|]+) \|$/gm)
  return new Map(
    [...rows].map(([, room, imports]) => [room, [...imports.matchAll(/`([^`]+)`/g)].map(([, name]) => name)]),
  )
}

const allowed = allowedImports()
const rooms = [...allowed].filter(([room]) => room !== INTERNAL)

/** Returns the room of a file: the deepest folder named in the tables, or undefined for entry points. */
function roomOf(path: string): string | undefined {
  const own = [...allowed.keys()].filter((room) => path.startsWith(`${room}/`) || path === `${room}.ts`)
  const room = own.sort((a, b) => b.length - a.length)[0]
  return isEntry(path, room) ? undefined : room
}

function isEntry(path: string, room: string | undefined): boolean {
  if (room === undefined || path === `${LIBRARY}/three/index.ts`) return true
  // A file at the top of a package is an entry point if it imports a room of the package.
  if (dirname(path) !== room || !HOMES.includes(room)) return false
  return (importsOf.get(path) ?? []).some((name) => name.startsWith(`${room}/`) && dirname(name) !== room)
}

/** Tells whether a room may import a file or a package. */
function isAllowed(room: string, name: string): boolean {
  const home = homeOf(`${room}/`)!
  const others = allowed.get(room)!
  if (/\.tsx?$/.test(name)) {
    const other = roomOf(name)
    return other === room || others.some((each) => other === each || other === `${home}/${each}`)
  }
  if (name.startsWith('.') || /^furrow\b/.test(name))
    return others.includes(name) || (home !== LIBRARY && [...PUBLIC, 'furrow/internal'].includes(name))
  // The tables list other packages only for the rooms of the library.
  return home !== LIBRARY || others.includes(name.replace(/^((?:@[^/]+\/)?[^/]+).*$/, '$1'))
}

/** Finds the cycles in a graph. Returns the nodes of each cycle in order. */
function circlesIn(graph: ReadonlyMap<string, readonly string[]>): string[] {
  const done = new Set<string>()
  const circles: string[] = []
  const visit = (node: string, trail: readonly string[]) => {
    const start = trail.indexOf(node)
    if (start >= 0) circles.push([...trail.slice(start), node].join(' -> '))
    if (start >= 0 || done.has(node)) return
    for (const next of graph.get(node) ?? []) visit(next, [...trail, node])
    done.add(node)
  }
  for (const node of graph.keys()) visit(node, [])
  return circles
}

/** Subfolders of rooms, in order. A subfolder may import only from earlier subfolders, and from the files in `shared`. */
const WITHIN = [
  {
    folder: 'author/auto',
    rooms: [
      'surface',
      'skeleton',
      'buckling',
      'anatomy',
      'strain',
      'lines',
      'fit',
      'limbs',
      'cloth',
      'joints',
      'raster',
      'blood',
      'bulges',
      'furrows',
      'character',
    ],
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

describe('the rooms', () => {
  it.each(HOMES)('of %s are all in the tables of docs/architecture', (home) => {
    const own = sources.filter(({ path }) => path.startsWith(`${home}/`))
    expect(own.length).toBeGreaterThan(0)
    const folders = new Set(own.map(({ path }) => path.split('/').slice(0, home.split('/').length + 1)))
    for (const folder of [...folders].map((parts) => parts.join('/'))) {
      if (!/\.\w+$/.test(folder)) expect([...allowed.keys()]).toContain(folder)
    }
  })

  it.each(rooms)('%s imports only %j and itself', (room) => {
    const files = sources.filter(({ path }) => roomOf(path) === room && !path.endsWith('.config.ts'))
    expect(files.length).toBeGreaterThan(0)
    const wrong = files.flatMap(({ path, imports }) =>
      imports.filter((name) => !isAllowed(room, name)).map((name) => `${path} imports ${name}`),
    )
    expect(wrong).toEqual([])
  })

  it.each(WITHIN)('in $folder import only earlier subfolders', ({ folder, rooms, shared }) => {
    const home = `${LIBRARY}/${folder}`
    const folders = readdirSync(join(ROOT, home), { withFileTypes: true })
    expect(folders.filter((entry) => entry.isDirectory()).map(({ name }) => name)).toEqual([...rooms].sort())
    rooms.forEach((room, index) => {
      const may = [...rooms.slice(0, index + 1).map((name) => `${name}/`), ...shared]
      const files = sources.filter(({ path }) => path.startsWith(`${home}/${room}/`))
      const wrong = files.flatMap(({ path, imports }) =>
        imports
          .filter((name) => name.startsWith(`${home}/`))
          .filter((name) => !may.some((start) => name.startsWith(`${home}/${start}`)))
          .map((name) => `${path} imports ${name}`),
      )
      expect(wrong).toEqual([])
    })
  })

  it('of files, commands and studio have no circular imports', () => {
    const graph = new Map<string, string[]>()
    for (const { path, imports } of sources) {
      const room = roomOf(path)
      const home = homeOf(path)
      if (room === undefined || home === LIBRARY) continue
      const others = imports.flatMap((name) => roomOf(name) ?? []).filter((other) => other !== room)
      graph.set(room, [...(graph.get(room) ?? []), ...others])
    }
    expect(circlesIn(graph)).toEqual([])
  })

  it('import other packages only by their entry points', () => {
    const packageOf = (path: string) => /^(packages\/\w+|studio)\//.exec(path)?.[1]
    const wrong = sources
      .filter(({ path }) => /^(packages|studio|stage|conformance|examples)\/(?!.*\.config\.ts$)/.test(path))
      .flatMap(({ path, imports }) =>
        imports
          .filter((name) => packageOf(name) !== undefined && packageOf(name) !== packageOf(path))
          .map((name) => `${path} imports ${name}`),
      )
    expect(wrong).toEqual([])
  })
})

it('the picture of the imports between rooms is up to date', async () => {
  const picture = readFileSync(join(ROOT, 'docs/figures/rooms.svg'), 'utf8')
  expect(picture, 'npm run rooms draws it').toBe(await drawRooms())
})

it('no files import each other in a circle', () => {
  expect(circlesIn(importsOf)).toEqual([])
})
