import { Document, NodeIO } from '@gltf-transform/core'
import { accessorsOf } from '../accessors.ts'

/** Material, names and extra fields of the face. */
export interface PlaneLooks {
  normalMap?: Uint8Array
  baseColour?: Uint8Array
  mesh?: string
  material?: string
  /** Extra fields of the node. */
  extras?: Record<string, unknown>
}

/** Makes a face that is a square with texture coordinates 0 to 1. Each blendshape lifts one corner a little. */
export async function planeFace(
  targets: readonly string[],
  { normalMap, baseColour, mesh = 'skin', material = 'skin', extras = {} }: PlaneLooks = {},
): Promise<Uint8Array> {
  const document = new Document()
  const accessor = accessorsOf(document)
  const vectors = (type: 'VEC2' | 'VEC3', ...values: number[]) => accessor(type, Float32Array.from(values))
  const skin = document.createMaterial(material)
  const texture = (bytes: Uint8Array) =>
    document
      .createTexture()
      .setImage(bytes as Uint8Array<ArrayBuffer>)
      .setMimeType('image/png')
  if (normalMap) skin.setNormalTexture(texture(normalMap))
  if (baseColour) skin.setBaseColorTexture(texture(baseColour))
  const primitive = document
    .createPrimitive()
    .setAttribute('POSITION', vectors('VEC3', 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0))
    .setAttribute('NORMAL', vectors('VEC3', 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1))
    .setAttribute('TEXCOORD_0', vectors('VEC2', 0, 1, 1, 1, 0, 0, 1, 0))
    .setIndices(accessor('SCALAR', Uint16Array.of(0, 1, 2, 1, 3, 2)))
    .setMaterial(skin)
  for (const [i, name] of targets.entries()) {
    const offsets = Array.from({ length: 12 }, (_, k) => (k === 3 * (i % 4) + 2 ? 0.1 : 0))
    primitive.addTarget(
      document.createPrimitiveTarget(name).setAttribute('POSITION', vectors('VEC3', ...offsets)),
    )
  }
  const made = document.createMesh(mesh).addPrimitive(primitive).setExtras({ targetNames: targets })
  document.createScene().addChild(document.createNode(mesh).setMesh(made).setExtras(extras))
  return new NodeIO().writeBinary(document)
}
