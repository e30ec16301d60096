import draco3d from 'draco3d'

export function createDracoDecoder(): Promise<unknown> {
  return draco3d.createDecoderModule()
}
