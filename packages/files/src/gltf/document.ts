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

/** Source JSON of each document that `documentOf` has read. */
const sources = new WeakMap<Document, GltfJson>()

/**
 * Decodes a glTF file to a document of glTF-Transform. Does not change `json` and `bin`. Converts triangle strips and
 * fans to lists. Drops extensions that glTF-Transform does not know.
 *
 * @param path path of the file, for errors.
 * @param who command, for errors, e.g. `furrow auto`.
 * @throws FurrowError if the file cannot be decoded.
 */
export async function documentOf({ json, bin }: Glb, path: string, who: string): Promise<Document> {
  try {
    const problem = decodingProblem(json, bin.length) ?? dracoProblem(json as CheckedJson, bin)
    if (problem) throw new Error(problem)
    // Hides the warnings of glTF-Transform about unknown extensions.
    const io = new WebIO().setLogger(new Logger(Logger.Verbosity.ERROR)).registerExtensions(ALL_EXTENSIONS)
    io.registerDependencies(await decodersFor(json.extensionsUsed ?? []))
    // glTF-Transform calls `slice` to get aligned copies of the data. `slice` of a Node buffer does not copy, so a plain
    // `Uint8Array` is passed.
    const view = new Uint8Array(bin.buffer as ArrayBuffer, bin.byteOffset, bin.length)
    // `readJSON` changes its JSON: it moves images from extensions to textures.
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

/** Returns the JSON that `documentOf` read. It contains the extensions that glTF-Transform dropped. */
export function sourceOf(document: Document): GltfJson {
  return sources.get(document) ?? {}
}

/** Loads only the decoders that a file needs, because they are slow to start. */
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
