// Compresses files with glTF-Transform, as users do before they publish a file.

import { Logger, NodeIO } from '@gltf-transform/core'
import { ALL_EXTENSIONS } from '@gltf-transform/extensions'
import { dedup, meshopt, prune, textureCompress } from '@gltf-transform/functions'
import draco3d from 'draco3d'
import { FurrowWrinkleMaps } from 'furrow/gltf'
import { MeshoptDecoder, MeshoptEncoder } from 'meshoptimizer'
import sharp from 'sharp'

/** Returns the transforms that docs/transform.md recommends, with lossless or lossy textures. */
export function compressing(lossless) {
  return [
    dedup(),
    prune(),
    textureCompress({ encoder: sharp, targetFormat: 'webp', resize: [512, 512], lossless }),
    meshopt({ encoder: MeshoptEncoder }),
  ]
}

export async function transformFile(input, output, transforms) {
  await MeshoptEncoder.ready
  const io = new NodeIO()
    .setLogger(new Logger(Logger.Verbosity.SILENT))
    .registerExtensions([...ALL_EXTENSIONS, FurrowWrinkleMaps])
    .registerDependencies({
      'meshopt.decoder': MeshoptDecoder,
      'meshopt.encoder': MeshoptEncoder,
      'draco3d.encoder': await draco3d.createEncoderModule(),
    })
  const document = await io.read(input)
  await document.transform(...transforms)
  await io.write(output, document)
}
