import draco3d from 'draco3d'

/** The decoder that glTF-Transform asks for. */
export function createDracoDecoder(): Promise<unknown> {
  return draco3d.createDecoderModule()
}
