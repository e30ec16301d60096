import { createReadStream } from 'node:fs'
import { readdir, readFile } from 'node:fs/promises'
import { extname, join, normalize, sep } from 'node:path'
import type { Plugin } from 'vite'

const TYPES: Record<string, string> = {
  '.glb': 'model/gltf-binary',
  '.json': 'application/json',
  '.png': 'image/png',
  '.jpg': 'image/jpeg',
  '.webp': 'image/webp',
}

/**
 * Serves the shipped faces under `/faces/` and copies them into a build. `/faces/index.json` lists their names.
 */
export function serveFaces(folder: string): Plugin {
  return {
    name: 'furrow-faces',
    configureServer({ middlewares }) {
      middlewares.use('/faces', async (request, response, next) => {
        const path = normalize(decodeURIComponent((request.url ?? '/').split('?')[0]))
        response.setHeader('Cache-Control', 'no-cache')
        if (path === `${sep}index.json`) {
          response.setHeader('Content-Type', 'application/json')
          response.end(JSON.stringify(await faceNames(folder)))
          return
        }
        const file = (await facePaths(folder)).find((name) => join(sep, name) === path)
        if (!file) return next()
        response.setHeader('Content-Type', TYPES[extname(file)])
        createReadStream(join(folder, file)).on('error', next).pipe(response)
      })
    },
    async generateBundle() {
      const names = JSON.stringify(await faceNames(folder))
      this.emitFile({ type: 'asset', fileName: 'faces/index.json', source: names })
      for (const path of await facePaths(folder)) {
        const source = await readFile(join(folder, path))
        this.emitFile({ type: 'asset', fileName: `faces/${path.split(sep).join('/')}`, source })
      }
    },
  }
}

/** Models with blendshapes: a hand is not a face. */
async function faceNames(folder: string): Promise<string[]> {
  const files = (await facePaths(folder)).filter((path) => extname(path) === '.glb' && !path.includes(sep))
  const areFaces = await Promise.all(files.map((path) => hasBlendshapes(join(folder, path))))
  return files
    .filter((_, i) => areFaces[i])
    .map((path) => path.slice(0, -'.glb'.length))
    .sort()
}

/** In a .glb the length of the JSON is at byte 12 and the JSON itself at byte 20 (glTF 2.0, section 4.4). */
async function hasBlendshapes(path: string): Promise<boolean> {
  const bytes = await readFile(path)
  const json = JSON.parse(bytes.toString('utf8', 20, 20 + bytes.readUInt32LE(12)))
  const meshes: { primitives: { targets?: unknown[] }[] }[] = json.meshes ?? []
  return meshes.some(({ primitives }) => primitives.some(({ targets }) => (targets?.length ?? 0) > 0))
}

/** Files that a page may request: the faces, not the scripts that build them. */
async function facePaths(folder: string): Promise<string[]> {
  const paths = await readdir(folder, { recursive: true })
  return paths.filter((path) => extname(path) in TYPES && !path.startsWith(`builder${sep}`))
}
