import { Document, NodeIO } from '@gltf-transform/core'

/** Makes a .glb of a flat sheet with one blendshape and `2 * side * side` triangles. */
export async function sheet(side: number): Promise<Uint8Array> {
  const document = new Document()
  const buffer = document.createBuffer()
  const row = side + 1
  const positions = new Float32Array(3 * row * row)
  const uvs = new Float32Array(2 * row * row)
  const normals = positions.map((_, i) => (i % 3 === 2 ? 1 : 0))
  const moved = new Float32Array(3 * row * row)
  for (let i = 0; i < row * row; i++) {
    const [u, v] = [(i % row) / side, Math.floor(i / row) / side]
    positions.set([u - 0.5, 0.5 - v, 0], 3 * i)
    uvs.set([u, v], 2 * i)
    moved[3 * i + 2] = 0.1 * u
  }
  const indices = new Uint32Array(6 * side * side)
  for (let i = 0; i < side * side; i++) {
    const a = Math.floor(i / side) * row + (i % side)
    indices.set([a, a + row, a + 1, a + 1, a + row, a + row + 1], 6 * i)
  }
  const accessor = (array: Float32Array | Uint32Array, type: 'VEC2' | 'VEC3' | 'SCALAR') =>
    document
      .createAccessor()
      .setArray(array as never)
      .setType(type)
      .setBuffer(buffer)
  const primitive = document
    .createPrimitive()
    .setIndices(accessor(indices, 'SCALAR'))
    .setAttribute('POSITION', accessor(positions, 'VEC3'))
    .setAttribute('NORMAL', accessor(normals, 'VEC3'))
    .setAttribute('TEXCOORD_0', accessor(uvs, 'VEC2'))
    .setMaterial(document.createMaterial('skin'))
    .addTarget(document.createPrimitiveTarget('bend').setAttribute('POSITION', accessor(moved, 'VEC3')))
  const mesh = document.createMesh('sheet').addPrimitive(primitive).setWeights([0])
  document.createScene().addChild(document.createNode('sheet').setMesh(mesh))
  return new NodeIO().writeBinary(document)
}
