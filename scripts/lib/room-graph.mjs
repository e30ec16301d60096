import { readdirSync } from 'node:fs'
import { join } from 'node:path'
import { instance } from '@viz-js/viz'
import { readImports } from './imports.mjs'
import { ROOT } from './run.mjs'

const LIBRARY = 'packages/furrow/src'

/**
 * A room is a top-level folder of the library's sources. These subfolders of the room `three`, one per renderer, count
 * as rooms too.
 */
const RENDERERS = ['three/webgl', 'three/webgpu']

/** Folders outside the library that import its entry points. */
const OUTSIDE = ['packages/files', 'packages/cli', 'studio', 'stage']

/** Patterns of import specifiers, with the folder of the package that they refer to. */
const PACKAGES = [
  [/^furrow-files(\/|$)/, 'packages/files/'],
  [/^furrow(\/|$)/, `${LIBRARY}/`],
]

/** Draws a graph of the rooms and their imports as SVG. */
export async function drawRooms() {
  const viz = await instance()
  return viz.renderString(toDot(libraryImports(), outsideImports()), { format: 'svg' })
}

/** Returns for each room of the library the rooms that it imports. */
function libraryImports() {
  const folders = readdirSync(join(ROOT, LIBRARY), { withFileTypes: true }).filter((entry) =>
    entry.isDirectory(),
  )
  const names = [...folders.map(({ name }) => name), ...RENDERERS]
  const imports = importsBetween(new Map(names.map((name) => [name, `${LIBRARY}/${name}`])))
  // A room with entry points may import its own inner rooms, as `three` imports `three/webgl`. The graph omits these
  // imports.
  for (const [room, others] of imports) {
    for (const other of others) if (other.startsWith(`${room}/`)) others.delete(other)
  }
  return imports
}

/** Returns for each folder outside the library the folders that it imports. The library is named `furrow`. */
function outsideImports() {
  const folders = OUTSIDE.map((folder) => [folder.split('/').at(-1), folder])
  return importsBetween(new Map([...folders, ['furrow', LIBRARY]]))
}

/**
 * Finds the imports between folders.
 *
 * @param {Map<string, string>} folders paths by name.
 * @returns {Map<string, Set<string>>} names of the imported folders, by name of the importing folder.
 */
function importsBetween(folders) {
  const roomOf = (path) => {
    const found = [...folders].filter(([, folder]) => path.startsWith(`${folder}/`))
    return found.sort(([, a], [, b]) => b.length - a.length)[0]?.[0]
  }
  const resolve = (specifier) => PACKAGES.find(([pattern]) => pattern.test(specifier))?.[1] ?? specifier
  const imports = new Map([...folders.keys()].map((name) => [name, new Set()]))
  for (const { path, imports: files } of readImports([LIBRARY, ...OUTSIDE])) {
    const room = roomOf(path)
    if (!room) continue
    for (const other of files.map((file) => roomOf(resolve(file)))) {
      if (other && other !== room) imports.get(room).add(other)
    }
  }
  return imports
}

/** Formats the graph in the DOT language of Graphviz. */
function toDot(library, outside) {
  const inner = edgesOf(library).map(([from, to]) => `"${from}" -> "${to}"`)
  const outer = edgesOf(outside).map(([from, to]) =>
    to === 'furrow' ? `"${from}" -> "react" [lhead=cluster_furrow]` : `"${from}" -> "${to}"`,
  )
  return `digraph rooms {
  bgcolor="#ffffff" ranksep=0.45 nodesep=0.25 compound=true
  node [shape=box style="rounded,filled" fillcolor="#f6f3ee" color="#8a7f70" fontname="Helvetica" fontsize=13]
  edge [color="#6b6358" arrowsize=0.7]
  subgraph cluster_furrow {
    label="packages/furrow/src" fontname="Helvetica" fontsize=12 color="#8a7f70" style="rounded"
    ${[...library.keys()].map((room) => `"${room}"`).join(' ')}
  }
  ${[...inner, ...outer].sort().join('\n  ')}
}`
}

/** Returns the imports as pairs. Omits a pair if its two folders are also connected through other folders. */
function edgesOf(imports) {
  const reaches = (from, to, skip) =>
    [...imports.get(from)].some((next) => next !== skip && (next === to || reaches(next, to)))
  return [...imports].flatMap(([from, others]) =>
    [...others].filter((to) => !reaches(from, to, to)).map((to) => [from, to]),
  )
}
