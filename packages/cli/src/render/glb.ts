import { readFile } from 'node:fs/promises'
import { FurrowError } from 'furrow'
import { firstLine } from '../images.ts'

/** The parts of a glTF document that are looked at before a browser is started. */
export interface GltfJson {
  meshes?: { extras?: { targetNames?: unknown }; primitives?: { targets?: unknown[] }[] }[]
  materials?: { extensions?: Record<string, unknown> }[]
  textures?: unknown[]
  images?: { uri?: unknown }[]
  buffers?: { uri?: unknown }[]
}

const WHO = 'furrow render'
const MAGIC = 0x46546c67
const JSON_CHUNK = 0x4e4f534a

/**
 * Reads the JSON of a `.glb` file.
 *
 * @throws FurrowError when the file is missing, no binary glTF 2.0, or cut off.
 */
export async function readGlb(path: string): Promise<GltfJson> {
  const bytes = await read(path)
  const problem = headerProblem(bytes)
  if (problem) throw fault(path, problem)
  const end = 20 + bytes.readUInt32LE(12)
  let json: GltfJson
  try {
    json = JSON.parse(bytes.toString('utf8', 20, end))
  } catch (error) {
    throw fault(path, `its JSON is broken (${firstLine(error)})`)
  }
  return json
}

/** Names of the blendshapes of each mesh that has some, as three.js names them. */
export function targetNames({ meshes = [] }: GltfJson): string[][] {
  return meshes
    .map(({ extras, primitives = [] }) => {
      const count = primitives[0]?.targets?.length ?? 0
      const names = extras?.targetNames
      if (Array.isArray(names) && names.length === count) return names.map(String)
      return Array.from({ length: count }, (_, i) => String(i))
    })
    .filter((names) => names.length > 0)
}

/** Addresses of the files beside the face that it needs. */
export function outerFiles({ images = [], buffers = [] }: GltfJson): string[] {
  return [...images, ...buffers]
    .map(({ uri }) => uri)
    .filter((uri): uri is string => typeof uri === 'string' && !uri.startsWith('data:'))
}

async function read(path: string): Promise<Buffer> {
  try {
    return await readFile(path)
  } catch (error) {
    throw new FurrowError({
      who: WHO,
      what: `cannot read the face ${path} (${firstLine(error)})`,
      remedy: 'check the path',
    })
  }
}

/** Why the bytes are no whole binary glTF 2.0 file; undefined where they are. */
export function headerProblem(bytes: Buffer): string | undefined {
  if (bytes.length === 0) return 'it is empty'
  if (bytes.length < 4 || bytes.readUInt32LE(0) !== MAGIC) return 'it does not begin with "glTF"'
  if (bytes.length < 20) return `it is cut off after ${bytes.length} bytes`
  if (bytes.readUInt32LE(4) !== 2) return `it is of version ${bytes.readUInt32LE(4)}`
  const length = bytes.readUInt32LE(8)
  if (length > bytes.length || 20 + bytes.readUInt32LE(12) > bytes.length) {
    return `it is cut off: ${bytes.length} of ${length} bytes`
  }
  if (bytes.readUInt32LE(16) !== JSON_CHUNK) return 'its first part is not JSON'
  return undefined
}

function fault(path: string, problem: string): FurrowError {
  return new FurrowError({
    who: WHO,
    what: `the face ${path} is not usable: ${problem}`,
    limit: 'a whole binary glTF 2.0 file (.glb)',
    remedy: 'export it again',
  })
}
