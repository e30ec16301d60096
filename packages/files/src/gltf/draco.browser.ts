import draco3d from 'draco3d'
import address from 'draco3d/draco_decoder.wasm?url'

/** The decoder that glTF-Transform asks for. By itself the package reads its WebAssembly from a disk. */
export async function createDracoDecoder(): Promise<unknown> {
  const response = await fetch(address)
  return draco3d.createDecoderModule({ wasmBinary: await response.arrayBuffer() })
}
