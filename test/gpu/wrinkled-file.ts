import { Document, type Material as FileMaterial, WebIO } from '@gltf-transform/core'
import { FurrowWrinkleMaps } from 'furrow/gltf'
import type { Mesh, Object3D } from 'three'
import { randomNormals } from '../cases.ts'
import { editGlb } from '../glb.ts'
import { seeded } from '../random.ts'
import { png } from './images.ts'

const SIZE = 16

/** Weights of four areas in the channels of one image. */
export const WEIGHTS = Uint8Array.from({ length: SIZE * SIZE * 4 }, seeded(11)).map(
  (_, i) => (i * 37 + (i >> 4) * 11) % 256,
)

/** Parts of the extension's JSON that tests edit. */
export interface WrinkleJson {
  layers: { normalTexture: { index: number } }[]
  areas: { name: string; layer?: number }[]
  drivers: unknown[]
}

export const driver = (area: string, target: string) => ({
  type: 'morph' as const,
  area,
  targets: [{ name: target, weight: 1 }],
  curve: [
    [0.2, 0],
    [1, 1],
  ] as [number, number][],
})

/** Makes a file with two quads side by side, one material, one blendshape, and four areas in the channels of one image. */
export async function wrinkledFile(
  spoil: (json: WrinkleJson) => unknown = () => {},
  // biome-ignore lint/suspicious/noExplicitAny: the complete JSON of the file
  edit: (json: any) => unknown = () => {},
): Promise<Uint8Array<ArrayBuffer>> {
  const document = new Document()
  const extension = document.createExtension(FurrowWrinkleMaps)
  const file = async (label: string, image: Promise<Blob>) =>
    document
      .createTexture(label)
      .setMimeType('image/png')
      .setImage(new Uint8Array(await (await image).arrayBuffer()))
  const normals = await file('normal', png(SIZE, SIZE, 8, 6, randomNormals(seeded(1), SIZE).data))
  const base = await file('base', png(SIZE, SIZE, 8, 6, randomNormals(seeded(2), SIZE).data))
  const masks = await file('areas', png(SIZE, SIZE, 8, 6, WEIGHTS))
  const layer = extension.createLayer('expression').setTexture('normalTexture', normals)
  const maps = extension
    .createMaterialWrinkles()
    .addLayer(layer)
    .setDrivers([driver('a', 'browInnerUp')])
  for (const [channel, name] of ['a', 'b', 'c', 'd'].entries()) {
    const area = extension.createArea(name).setLayer(layer).setTexture(masks, channel)
    maps.addArea(area.setActivation(name === 'b' ? 0.25 : 0))
  }
  const material = document.createMaterial('skin').setNormalTexture(base).setRoughnessFactor(0.7)
  material.setMetallicFactor(0).setExtension(FurrowWrinkleMaps.EXTENSION_NAME, maps)
  const mesh = document
    .createMesh('face')
    .setExtras({ targetNames: ['browInnerUp'] })
    .setWeights([0])
  for (const x of [-1, 0]) mesh.addPrimitive(quad(document, x, material))
  document.createScene().addChild(document.createNode('face').setMesh(mesh))
  const bytes = await new WebIO().registerExtensions([FurrowWrinkleMaps]).writeBinary(document)
  return editGlb(bytes, (json) => {
    spoil(json.materials[0].extensions.FURROW_wrinkle_maps)
    edit(json)
  })
}

function quad(document: Document, x: number, material: FileMaterial) {
  const buffer = document.getRoot().listBuffers()[0] ?? document.createBuffer()
  const accessor = (
    type: 'VEC2' | 'VEC3' | 'SCALAR',
    data: Float32Array<ArrayBuffer> | Uint16Array<ArrayBuffer>,
  ) => document.createAccessor().setType(type).setArray(data).setBuffer(buffer)
  const corners = [0, 0, 1, 0, 0, 1, 1, 1]
  const at = (i: number) => [x + corners[2 * i], 2 * corners[2 * i + 1] - 1, 0]
  const indices = [0, 1, 2, 3]
  return document
    .createPrimitive()
    .setMaterial(material)
    .setIndices(accessor('SCALAR', Uint16Array.of(0, 1, 2, 2, 1, 3)))
    .setAttribute('POSITION', accessor('VEC3', Float32Array.from(indices.flatMap(at))))
    .setAttribute('NORMAL', accessor('VEC3', Float32Array.from(indices.flatMap(() => [0, 0, 1]))))
    .setAttribute(
      'TEXCOORD_0',
      accessor(
        'VEC2',
        Float32Array.from(indices.flatMap((i) => [(at(i)[0] + 1) / 2, 1 - corners[2 * i + 1]])),
      ),
    )
    .addTarget(
      document
        .createPrimitiveTarget('browInnerUp')
        .setAttribute('POSITION', accessor('VEC3', new Float32Array(12))),
    )
}

/** Returns the two quads in a loaded scene or in a copy of the scene. */
export function faceMeshes(root: Object3D): Mesh[] {
  return root.getObjectByName('face')!.children as Mesh[]
}

/** Adds a mesh `eyes` before the face, with the same material and other blendshapes. Use as `edit` of `wrinkledFile`. */
// biome-ignore lint/suspicious/noExplicitAny: JSON
export function addEyes(json: any): void {
  const [face] = json.meshes
  json.meshes.push({ ...face, name: 'eyes', extras: { targetNames: ['eyeLookUpLeft'] } })
  json.nodes.push({ name: 'eyes', mesh: json.meshes.length - 1, translation: [0, 0, -1] })
  json.scenes[0].nodes.unshift(json.nodes.length - 1)
}
