import { type Document, GLB_BUFFER, type GLTF, Logger, WebIO } from '@gltf-transform/core'
import { ALL_EXTENSIONS } from '@gltf-transform/extensions'
import { cannotRead } from '../base/errors.ts'
import { decodingProblem } from '../checks/document.ts'
import { dracoProblem } from '../checks/draco.ts'
import { meshProblem } from '../checks/meshes.ts'
import type { CheckedJson } from '../json/checked-json.ts'
import type { GltfJson } from '../json/gltf-json.ts'
import type { Glb } from './glb.ts'
import { listTriangles } from './triangle-lists.ts'

/** JSON of each document that `documentOf` read. */
const sources = new WeakMap<Document, GltfJson>()

/**
 * Decodes a file, compressed or not, and leaves it as it is. Strips of triangles become lists, and extensions that glTF-Transform does
 * not know are dropped.
 *
 * @param path of the file, for errors.
 * @throws FurrowError when it cannot be decoded.
 */
export async function documentOf({ json, bin }: Glb, path: string, who: string): Promise<Document> {
  try {
    const problem = decodingProblem(json, bin.length) ?? dracoProblem(json as CheckedJson, bin)
    if (problem) throw new Error(problem)
    // Below errors the logger warns of extensions that are of no interest here.
    const io = new WebIO().setLogger(new Logger(Logger.Verbosity.ERROR)).registerExtensions(ALL_EXTENSIONS)
    io.registerDependencies(await decodersFor(json.extensionsUsed ?? []))
    // A plain view: slices of a Buffer are not copies, and accessors need theirs to be aligned.
    const view = new Uint8Array(bin.buffer as ArrayBuffer, bin.byteOffset, bin.length)
    // Reading moves the images of extensions into the textures.
    const copy = structuredClone(json) as GLTF.IGLTF
    const document = await io.readJSON({ json: copy, resources: { [GLB_BUFFER]: view } })
    const fault = meshProblem(document) ?? listTriangles(document)
    if (fault) throw new Error(fault)
    sources.set(document, json)
    return document
  } catch (error) {
    const hints = { limit: 'glTF 2.0', remedy: 'check the file with furrow validate' }
    throw cannotRead(who, `the face ${path}`, error, hints)
  }
}

/** The JSON that `documentOf` read a document from: that of extensions which glTF-Transform does not know is there too. */
export function sourceOf(document: Document): GltfJson {
  return sources.get(document) ?? {}
}

/** Decoders are slow to start, and few files need them. */
async function decodersFor(extensions: readonly string[]): Promise<Record<string, unknown>> {
  const decoders: Record<string, unknown> = {}
  if (extensions.includes('KHR_draco_mesh_compression')) {
    const { createDracoDecoder } = await import('#draco')
    decoders['draco3d.decoder'] = await createDracoDecoder()
  }
  if (extensions.some((name) => name.endsWith('_meshopt_compression'))) {
    const { MeshoptDecoder } = await import('meshoptimizer/decoder')
    await MeshoptDecoder.ready
    decoders['meshopt.decoder'] = MeshoptDecoder
  }
  return decoders
}
