import draco3d from 'draco3d'
import address from 'draco3d/draco_decoder.wasm?url'

/**
 * Creates the Draco decoder for glTF-Transform. Fetches its WebAssembly, because the package would read it from disk.
 */
export async function createDracoDecoder(): Promise<unknown> {
  const response = await fetch(address)
  return draco3d.createDecoderModule({ wasmBinary: await response.arrayBuffer() })
}
