import draco3d from 'draco3d'

/** Creates the decoder for glTF-Transform. */
export function createDracoDecoder(): Promise<unknown> {
  return draco3d.createDecoderModule()
}
