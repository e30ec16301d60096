import { type Document, Logger, NodeIO } from '@gltf-transform/core'
import { ALL_EXTENSIONS } from '@gltf-transform/extensions'
import { cannotRead } from '../errors.ts'
import { readBytes } from '../files.ts'

/**
 * Reads a .glb or .gltf file, compressed or not. Extensions that glTF-Transform does not know are dropped.
 *
 * @throws FurrowError when it cannot be read.
 */
export async function readDocument(path: string, who: string): Promise<Document> {
  const bytes = await readBytes(path, who, 'the face')
  try {
    // Below errors the logger warns of extensions that are of no interest here.
    const io = new NodeIO().setLogger(new Logger(Logger.Verbosity.ERROR)).registerExtensions(ALL_EXTENSIONS)
    io.registerDependencies(await decodersFor(bytes))
    return await io.read(path)
  } catch (error) {
    const hints = { limit: 'glTF 2.0', remedy: 'check the path and the file' }
    throw cannotRead(who, `the face ${path}`, error, hints)
  }
}

/** Decoders are slow to start, and few files need them. */
async function decodersFor(bytes: Buffer): Promise<Record<string, unknown>> {
  const decoders: Record<string, unknown> = {}
  if (bytes.includes('KHR_draco_mesh_compression')) {
    const { default: draco3d } = await import('draco3d')
    decoders['draco3d.decoder'] = await draco3d.createDecoderModule()
  }
  if (bytes.includes('_meshopt_compression')) {
    const { MeshoptDecoder } = await import('meshoptimizer/decoder')
    await MeshoptDecoder.ready
    decoders['meshopt.decoder'] = MeshoptDecoder
  }
  return decoders
}
