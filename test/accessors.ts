import type { Accessor, Document } from '@gltf-transform/core'

/** Returns a function that creates accessors in the document's first buffer. */
export function accessorsOf(document: Document) {
  const buffer = document.getRoot().listBuffers()[0] ?? document.createBuffer()
  return (
    type: 'SCALAR' | 'VEC2' | 'VEC3' | 'VEC4' | 'MAT4',
    array: Float32Array | Uint8Array | Uint16Array | Uint32Array,
  ): Accessor =>
    document
      .createAccessor()
      .setType(type)
      .setArray(array as Float32Array<ArrayBuffer>)
      .setBuffer(buffer)
}
