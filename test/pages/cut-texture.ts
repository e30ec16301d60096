import { type Accessor, type Document, Texture } from '@gltf-transform/core'
import sharp from 'sharp'

/** Splits the UV layout of a mesh at the middle of the face, x = 0, into two islands side by side. The face looks the same. */
export async function cutTexture(document: Document, meshName: string): Promise<void> {
  const mesh = document
    .getRoot()
    .listMeshes()
    .find((each) => each.getName() === meshName)!
  const textures = new Set(
    mesh.listPrimitives().flatMap((each) => document.getGraph().listChildren(each.getMaterial()!)),
  )
  for (const primitive of mesh.listPrimitives()) {
    const positions = primitive.getAttribute('POSITION')!
    const corners = [...primitive.getIndices()!.getArray()!]
    const xOf = (vertex: number) => positions.getElement(vertex, [])[0]!
    const vertices: { old: number; side: number }[] = []
    const indexOf = new Map<number, number>()
    const indices = corners.map((old, i) => {
      const [a, b, c] = corners.slice(i - (i % 3), i - (i % 3) + 3) as [number, number, number]
      const side = xOf(a) + xOf(b) + xOf(c) > 0 ? 1 : 0
      const key = 2 * old + side
      if (!indexOf.has(key)) indexOf.set(key, vertices.push({ old, side }) - 1)
      return indexOf.get(key)!
    })
    primitive.getIndices()!.setArray(new Uint32Array(indices))
    const rows = vertices.map(({ old }) => old)
    for (const owner of [primitive, ...primitive.listTargets()])
      for (const semantic of owner.listSemantics()) pick(owner.getAttribute(semantic)!, rows)
    const uvs = primitive.getAttribute('TEXCOORD_0')!
    for (const [i, { side }] of vertices.entries()) {
      const [u, v] = uvs.getElement(i, [0, 0])
      uvs.setElement(i, [(u + side) / 2, v])
    }
  }
  for (const texture of textures) if (texture instanceof Texture) await doubled(texture)
}

/** Rebuilds an accessor from its elements at the given indices. */
function pick(accessor: Accessor, rows: readonly number[]): void {
  const [size, old] = [accessor.getElementSize(), accessor.getArray()!]
  const picked = new (old.constructor as Float32ArrayConstructor)(size * rows.length)
  for (const [i, row] of rows.entries()) picked.set(old.subarray(size * row, size * (row + 1)), size * i)
  accessor.setArray(picked)
}

/** Replaces an image by two copies side by side, without changing the size. */
async function doubled(texture: Texture): Promise<void> {
  const image = sharp(texture.getImage()!)
  const { width, height, format } = await image.metadata()
  const half = await image.resize(width / 2, height, { fit: 'fill' }).toBuffer()
  const sides = [0, width / 2].map((left) => ({ input: half, left, top: 0 }))
  const both = sharp({ create: { width, height, channels: 3, background: '#000' } }).composite(sides)
  texture.setImage(await both.toFormat(format).toBuffer())
}
