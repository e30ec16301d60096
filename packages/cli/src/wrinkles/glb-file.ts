import { readFile } from 'node:fs/promises'
import { Logger, NodeIO } from '@gltf-transform/core'
import { ALL_EXTENSIONS } from '@gltf-transform/extensions'
import { FurrowError } from 'furrow'
import { firstLine } from '../images.ts'
import { headerProblem } from '../render/glb.ts'
import { shapeProblem } from './glb-shape.ts'

type Extensions = Record<string, unknown>

export interface TextureInfo {
  index: number
  texCoord?: number
}

export interface GltfMaterial {
  name?: string
  pbrMetallicRoughness?: { baseColorTexture?: TextureInfo }
  normalTexture?: TextureInfo
  extensions?: Extensions
}

export interface GltfMesh {
  name?: string
  primitives: {
    attributes?: Record<string, number>
    indices?: number
    mode?: number
    material?: number
    targets?: Record<string, number>[]
  }[]
  extras?: { targetNames?: unknown }
}

/** The parts of a glTF document that wrinkles touch; all else is kept as it is. */
export interface GltfJson {
  extensionsUsed?: string[]
  extensionsRequired?: string[]
  buffers?: { byteLength: number; uri?: string }[]
  bufferViews?: { buffer: number; byteOffset?: number; byteLength: number }[]
  accessors?: object[]
  images?: { name?: string; mimeType?: string; uri?: string; bufferView?: number }[]
  textures?: { name?: string; sampler?: number; source?: number; extensions?: Extensions }[]
  samplers?: object[]
  materials?: GltfMaterial[]
  meshes?: GltfMesh[]
  nodes?: { name?: string; mesh?: number }[]
  extensions?: Extensions
}

/** A binary glTF file in its two parts. It is changed part by part, so that whatever else it holds survives. */
export interface Glb {
  json: GltfJson
  /** The binary part; empty where there is none. */
  bin: Uint8Array
  /** Size of the file it was read from. */
  fileBytes: number
  warnings: string[]
}

/**
 * Reads a `.glb`, or a `.gltf` with the files beside it.
 *
 * @throws FurrowError when the file is missing, cut off, or not glTF 2.0.
 */
export async function readGlbFile(path: string, who: string): Promise<Glb> {
  if (/\.gltf$/i.test(path)) return readGltfFile(path, who)
  let bytes: Buffer
  try {
    bytes = await readFile(path)
  } catch (error) {
    throw new FurrowError({
      who,
      what: `cannot read ${path} (${firstLine(error)})`,
      remedy: 'check the path',
    })
  }
  return decodeGlb(bytes, path, who)
}

/** Takes the bytes of a `.glb` apart. Throws FurrowError as `readGlbFile` does. */
export function decodeGlb(bytes: Buffer, path: string, who: string): Glb {
  const header = headerProblem(bytes)
  if (header) throw unusable(path, who, header)
  const end = 20 + bytes.readUInt32LE(12)
  let json: GltfJson
  try {
    json = JSON.parse(bytes.toString('utf8', 20, end))
  } catch (error) {
    throw unusable(path, who, `its JSON is broken (${firstLine(error)})`)
  }
  const shape = shapeProblem(json)
  if (shape) throw unusable(path, who, shape)
  const bin = binOf(bytes, end)
  if (!bin) throw unusable(path, who, 'its binary part is cut off')
  return { json, bin, fileBytes: bytes.length, warnings: [] }
}

/** Puts the parts together again. */
export function encodeGlb({ json, bin }: Glb): Uint8Array {
  const text = padded(Buffer.from(JSON.stringify(json)), 0x20)
  const data = padded(bin, 0)
  const header = Buffer.alloc(20)
  const length = 20 + text.length + (data.length > 0 ? 8 + data.length : 0)
  for (const [i, value] of [0x46546c67, 2, length, text.length, JSON_CHUNK].entries()) {
    header.writeUInt32LE(value, 4 * i)
  }
  if (data.length === 0) return Buffer.concat([header, text])
  const second = Buffer.alloc(8)
  second.writeUInt32LE(data.length, 0)
  second.writeUInt32LE(BIN_CHUNK, 4)
  return Buffer.concat([header, text, second, data])
}

const JSON_CHUNK = 0x4e4f534a
const BIN_CHUNK = 0x004e4942

function binOf(bytes: Buffer, at: number): Uint8Array | undefined {
  if (bytes.length < at + 8) return new Uint8Array()
  if (bytes.readUInt32LE(at + 4) !== BIN_CHUNK) return new Uint8Array()
  const end = at + 8 + bytes.readUInt32LE(at)
  return end > bytes.length ? undefined : bytes.subarray(at + 8, end)
}

/** Text files are turned into binary ones; glTF-Transform drops extensions that it does not know. */
async function readGltfFile(path: string, who: string): Promise<Glb> {
  try {
    const io = new NodeIO().setLogger(new Logger(Logger.Verbosity.SILENT)).registerExtensions(ALL_EXTENSIONS)
    const source = await io.readAsJSON(path)
    const known = ALL_EXTENSIONS.map(({ EXTENSION_NAME }) => EXTENSION_NAME)
    const lost = (source.json.extensionsUsed ?? []).filter((name) => !known.includes(name))
    const glb = decodeGlb(Buffer.from(await io.writeBinary(await io.readJSON(source))), path, who)
    if (lost.length > 0)
      glb.warnings.push(`${who}: ${path} loses ${lost.join(', ')}; a .glb keeps all it holds`)
    return glb
  } catch (error) {
    throw error instanceof FurrowError ? error : unusable(path, who, firstLine(error))
  }
}

function padded(bytes: Uint8Array, fill: number): Uint8Array {
  const rest = (4 - (bytes.length % 4)) % 4
  return rest === 0 ? bytes : Buffer.concat([bytes, Buffer.alloc(rest, fill)])
}

function unusable(path: string, who: string, problem: string): FurrowError {
  return new FurrowError({
    who,
    what: `${path} is not usable: ${problem}`,
    limit: 'a whole glTF 2.0 file (.glb, .gltf)',
    remedy: 'export it again',
  })
}
