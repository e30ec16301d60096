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
 * Decodes a file, compressed or not, without changing it. Converts triangle strips to lists. Drops extensions that
 * glTF-Transform does not know.
 *
 * @param path path of the file, for errors.
 * @throws FurrowError if the file cannot be decoded.
 */
export async function documentOf({ json, bin }: Glb, path: string, who: string): Promise<Document> {
  try {
    const problem = decodingProblem(json, bin.length) ?? dracoProblem(json as CheckedJson, bin)
    if (problem) throw new Error(problem)
    // The logger would warn about unknown extensions.
    const io = new WebIO().setLogger(new Logger(Logger.Verbosity.ERROR)).registerExtensions(ALL_EXTENSIONS)
    io.registerDependencies(await decodersFor(json.extensionsUsed ?? []))
    // Not a Buffer: its slices are not copies, and accessors need aligned copies.
    const view = new Uint8Array(bin.buffer as ArrayBuffer, bin.byteOffset, bin.length)
    // Reading changes the JSON: it moves images from extensions to textures.
    const copy = structuredClone(json) as GLTF.IGLTF
    const document = await io.readJSON({ json: copy, resources: { [GLB_BUFFER]: view } })
    const geometryProblem = meshProblem(document) ?? listTriangles(document)
    if (geometryProblem) throw new Error(geometryProblem)
    sources.set(document, json)
    return document
  } catch (error) {
    const hints = { limit: 'glTF 2.0', remedy: 'check the file with furrow validate' }
    throw cannotRead(who, `the face ${path}`, error, hints)
  }
}

/** Returns the JSON from which `documentOf` read a document, including extensions unknown to glTF-Transform. */
export function sourceOf(document: Document): GltfJson {
  return sources.get(document) ?? {}
}

/** Loads the decoders that a file needs. They are slow to start. */
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
