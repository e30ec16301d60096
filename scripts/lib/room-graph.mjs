import { readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { instance } from '@viz-js/viz'
import { readImports } from './imports.mjs'
import { ROOT } from './run.mjs'

const LIBRARY = 'packages/furrow/src'

/** Rooms outside the library, by folder. */
const OTHERS = ['packages/files', 'packages/cli', 'studio', 'stage']

/** Rooms inside `three`, which each serve one renderer. */
const RENDERERS = ['three/webgl', 'three/webgpu']

/** Draws the rooms and their imports as an SVG. */
export async function drawRooms() {
  const viz = await instance()
  return viz.renderString(toDot(readRooms()), { format: 'svg' })
}

/**
 * Reads which room imports which.
 *
 * @returns {Map<string, Set<string>>} for each room, the rooms it imports.
 */
export function readRooms() {
  const library = readdirSync(join(ROOT, LIBRARY), { withFileTypes: true })
  const inside = library.filter((entry) => entry.isDirectory()).map(({ name }) => name)
  const folders = new Map([
    ...[...inside, ...RENDERERS].map((name) => [name, `${LIBRARY}/${name}`]),
    ...OTHERS.map((folder) => [folder.split('/').at(-1), folder]),
  ])
  const entries = workspaceEntries()
  const entryFiles = new Set(entries.values())
  const roomOf = (path) => {
    const [deepest] = [...folders]
      .filter(([, folder]) => path.startsWith(`${folder}/`))
      .sort(([, a], [, b]) => b.length - a.length)
    return deepest?.[0]
  }
  const rooms = new Map([...folders.keys()].map((name) => [name, new Set()]))
  for (const { path, imports } of readImports([LIBRARY, ...OTHERS])) {
    const room = roomOf(path)
    for (const name of imports) {
      const other = roomOf(entries.get(name) ?? name)
      // An entry may export from rooms within its own, as `furrow/three` does from `three/webgl`.
      if (entryFiles.has(path) && other?.startsWith(`${room}/`)) continue
      if (room && other && other !== room) rooms.get(room).add(other)
    }
  }
  return rooms
}

/** Source file of each specifier under which workspaces import each other, such as `furrow/author`. */
function workspaceEntries() {
  return new Map(
    ['furrow', 'files'].flatMap((folder) => {
      const { name, exports } = JSON.parse(
        readFileSync(join(ROOT, 'packages', folder, 'package.json'), 'utf8'),
      )
      return Object.entries(exports).flatMap(([entry, { 'furrow-source': source }]) =>
        source ? [[name + entry.slice(1), `packages/${folder}/${source.slice(2)}`]] : [],
      )
    }),
  )
}

/** The graph in Graphviz's language, without the edges that others imply. */
function toDot(rooms) {
  const reached = (from, skip) => {
    const seen = new Set()
    const visit = (room) => {
      for (const next of rooms.get(room)) {
        if (seen.has(next) || (room === from && next === skip)) continue
        seen.add(next)
        visit(next)
      }
    }
    visit(from)
    return seen
  }
  const edges = [...rooms].flatMap(([room, others]) =>
    [...others].filter((other) => !reached(room, other).has(other)).map((other) => `"${room}" -> "${other}"`),
  )
  const library = [...rooms.keys()].filter((room) => !OTHERS.some((folder) => folder.endsWith(room)))
  return `digraph rooms {
  bgcolor="#ffffff" ranksep=0.45 nodesep=0.25
  node [shape=box style="rounded,filled" fillcolor="#f6f3ee" color="#8a7f70" fontname="Helvetica" fontsize=13]
  edge [color="#6b6358" arrowsize=0.7]
  subgraph cluster_furrow {
    label="packages/furrow/src" fontname="Helvetica" fontsize=12 color="#c9c0b2" style="rounded"
    ${library.map((room) => `"${room}"`).join(' ')}
  }
  ${[...rooms.keys()].map((room) => `"${room}"`).join(' ')}
  ${edges.sort().join('\n  ')}
}`
}
