import draco3d from 'draco3d'
import address from 'draco3d/draco_decoder.wasm?url'

/** Creates the decoder for glTF-Transform. Fetches the WebAssembly, which the package would read from disk. */
export async function createDracoDecoder(): Promise<unknown> {
  const response = await fetch(address)
  return draco3d.createDecoderModule({ wasmBinary: await response.arrayBuffer() })
}
