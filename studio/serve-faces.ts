import { createReadStream } from 'node:fs'
import { readdir, readFile } from 'node:fs/promises'
import { extname, join, relative, sep } from 'node:path'
import { pipeline } from 'node:stream'
import type { Plugin } from 'vite'

const TYPES: Record<string, string> = {
  '.glb': 'model/gltf-binary',
  '.json': 'application/json',
  '.png': 'image/png',
  '.jpg': 'image/jpeg',
  '.webp': 'image/webp',
}

type Warn = (text: string) => void

/** Serves the shipped faces under `/faces/` and copies them into a build. `/faces/index.json` lists their names. */
export function serveFaces(folder: string): Plugin {
  return {
    name: 'furrow-faces',
    configureServer({ middlewares, config }) {
      const warn: Warn = (text) => config.logger.warnOnce(text)
      middlewares.use('/faces', async (request, response, next) => {
        try {
          const path = pathOf(request.url ?? '/')
          response.setHeader('Cache-Control', 'no-cache')
          if (path === 'index.json') {
            response.setHeader('Content-Type', 'application/json')
            response.end(JSON.stringify(await faceNames(folder, warn)))
            return
          }
          const file = (await facePaths(folder)).find((name) => name === path)
          if (!file) {
            response.writeHead(path === undefined ? 400 : 404).end()
            return
          }
          response.setHeader('Content-Type', TYPES[extname(file)])
          pipeline(createReadStream(join(folder, file)), response, () => {})
        } catch (error) {
          next(error)
        }
      })
    },
    async generateBundle() {
      const names = JSON.stringify(await faceNames(folder, (text) => this.warn(text)))
      this.emitFile({ type: 'asset', fileName: 'faces/index.json', source: names })
      for (const path of await facePaths(folder)) {
        const source = await readFile(join(folder, path))
        this.emitFile({ type: 'asset', fileName: `faces/${path}`, source })
      }
    },
  }
}

/** Returns the path of a URL without leading slash, or undefined if it is malformed. */
function pathOf(url: string): string | undefined {
  try {
    return decodeURIComponent(url.split('?')[0]).slice(1)
  } catch {
    return undefined
  }
}

/** Lists the names of models that have blendshapes. Other models, such as a hand, are not faces. */
async function faceNames(folder: string, warn: Warn): Promise<string[]> {
  const files = (await facePaths(folder)).filter((path) => extname(path) === '.glb' && !path.includes('/'))
  const hasShapes = await Promise.all(
    files.map((file) =>
      hasBlendshapes(join(folder, file)).catch((error: Error) => {
        warn(`faces: skipped ${JSON.stringify(file)}, got an incomplete .glb (${error.message})`)
        return false
      }),
    ),
  )
  return files
    .filter((_, i) => hasShapes[i])
    .map((path) => path.slice(0, -'.glb'.length))
    .sort()
}

/**
 * Whether a .glb has blendshapes. The file length is at byte 8, the JSON length at byte 12, and the JSON at byte 20 (glTF 2.0, section
 * 4.4).
 *
 * @throws Error if the file is not a complete .glb.
 */
async function hasBlendshapes(path: string): Promise<boolean> {
  const bytes = await readFile(path)
  const length = bytes.readUInt32LE(8)
  if (length > bytes.length) throw new Error(`${bytes.length} of ${length} bytes`)
  const json = JSON.parse(bytes.toString('utf8', 20, 20 + bytes.readUInt32LE(12)))
  const meshes: { primitives: { targets?: unknown[] }[] }[] = json.meshes ?? []
  return meshes.some(({ primitives }) => primitives.some(({ targets }) => (targets?.length ?? 0) > 0))
}

/**
 * Lists the paths (with `/`) of the files that a page can request. Excludes the scripts that build faces. Excludes symbolic links, which can
 * lead out of the folder.
 */
async function facePaths(folder: string): Promise<string[]> {
  const entries = await readdir(folder, { recursive: true, withFileTypes: true })
  return entries
    .filter((entry) => entry.isFile() && extname(entry.name) in TYPES)
    .map(({ parentPath, name }) => relative(folder, join(parentPath, name)).split(sep).join('/'))
    .filter((path) => !path.startsWith('builder/'))
}
