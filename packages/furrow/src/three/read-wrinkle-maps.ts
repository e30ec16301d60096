import type { Material, Mesh, Object3D, Texture } from 'three'
import type { GLTF } from 'three/addons/loaders/GLTFLoader.js'
import { CHANNEL, channelOf } from '../core/channels.ts'
import type { Area, Layer, RgbaImage, WrinkleSet } from '../core/types.ts'
import { parseWrinkleMaps, WRINKLE_MAPS, type WrinkleDriver, type WrinkleMaps } from '../core/wrinkle-maps.ts'
import { readTexture } from './read-texture.ts'

/** What a file says of one face's wrinkles. */
export interface LoadedWrinkles {
  /** The meshes of the face, which share its material: the primitives of one glTF mesh. The first one drives. */
  meshes: [Mesh, ...Mesh[]]
  /** The same object for all faces with one material in the file. */
  set: WrinkleSet
  drivers: WrinkleDriver[]
}

type Parser = GLTF['parser']

/**
 * Reads FURROW_wrinkle_maps from a file that three.js's `GLTFLoader` has loaded, one entry for each face that
 * has it. Plain data, for whatever renderer; `WrinkleLoaderPlugin` does it by itself.
 *
 * @throws FurrowError where the extension is malformed or an image cannot be read.
 */
export async function readWrinkleMaps(gltf: GLTF, parser: Parser = gltf.parser): Promise<LoadedWrinkles[]> {
  const found: LoadedWrinkles[] = []
  const sets = new Map<object, Promise<WrinkleSet>>()
  for (const meshes of facesOf(gltf, parser)) {
    const json = extensionOf(meshes[0].material as Material, parser)
    if (!json) continue
    const maps = parseWrinkleMaps(json, parser.json.textures?.length ?? 0)
    // Materials that the loader cloned from one of the file share what was read for it.
    if (!sets.has(json)) sets.set(json, readSet(maps, parser))
    found.push({ meshes, set: await sets.get(json)!, drivers: maps.drivers })
  }
  return found
}

/**
 * Takes the tangents of wrinkled meshes with blendshapes out of a file about to be loaded, to be called by a plugin's
 * `beforeRoot`: three.js does not morph tangents, and derives better ones from the moved surface at each pixel.
 */
export function dropMorphedTangents({ json }: Parser): void {
  for (const { primitives } of json.meshes ?? []) {
    for (const { attributes, targets, material } of primitives) {
      if (targets && json.materials?.[material]?.extensions?.[WRINKLE_MAPS]) delete attributes.TANGENT
    }
  }
}

/** Meshes by the face they belong to: the primitives of one glTF mesh that share a material are one. */
function facesOf(gltf: GLTF, parser: Parser): [Mesh, ...Mesh[]][] {
  const faces = new Map<Object3D, Map<Material, [Mesh, ...Mesh[]]>>()
  for (const scene of gltf.scenes) {
    scene.traverse((object) => {
      const mesh = object as Mesh
      if (!mesh.isMesh) return
      const whole = isPart(mesh, parser) ? mesh.parent! : mesh
      const parts = faces.get(whole) ?? new Map<Material, [Mesh, ...Mesh[]]>()
      faces.set(whole, parts)
      const material = mesh.material as Material
      const meshes = parts.get(material)
      if (!meshes) parts.set(material, [mesh])
      else if (!meshes.includes(mesh)) meshes.push(mesh)
    })
  }
  return [...faces.values()].flatMap((parts) => [...parts.values()])
}

/** Whether the loader made a group of a glTF mesh, and this of one of its primitives. */
function isPart(mesh: Mesh, parser: Parser): boolean {
  const index = parser.associations.get(mesh)?.meshes
  return index !== undefined && parser.json.meshes[index].primitives.length > 1
}

function extensionOf(material: Material, parser: Parser): object | undefined {
  const index = parser.associations.get(material)?.materials
  return index === undefined ? undefined : parser.json.materials[index].extensions?.[WRINKLE_MAPS]
}

async function readSet(maps: WrinkleMaps, parser: Parser): Promise<WrinkleSet> {
  const images = await readImages(maps, parser)
  const layers = maps.layers.map((layer): Layer => {
    const { name, kind, normalTexture, baseColorTexture, roughnessTexture, occlusionTexture } = layer
    return {
      name,
      kind,
      normal: images.get(normalTexture.index)!,
      normalScale: normalTexture.scale,
      ...(baseColorTexture && { baseColor: images.get(baseColorTexture.index)! }),
      ...(roughnessTexture && {
        roughness: channelOf(images.get(roughnessTexture.index)!, CHANNEL.roughness),
      }),
      ...(occlusionTexture && {
        occlusion: channelOf(images.get(occlusionTexture.index)!, CHANNEL.occlusion),
        occlusionStrength: occlusionTexture.strength,
      }),
    }
  })
  const areas = maps.areas.map(
    ({ name, layer, texture, channel, combine, activation }): Area => ({
      name,
      layer: layers[layer].name,
      combine,
      activation,
      weights: channelOf(images.get(texture.index)!, channel),
    }),
  )
  return { layers, areas }
}

/** The pixels of all textures that a set needs, by their index; heights are for tools. */
async function readImages({ layers, areas }: WrinkleMaps, parser: Parser): Promise<Map<number, RgbaImage>> {
  const references = [
    ...layers.flatMap((layer) => [
      layer.normalTexture,
      layer.baseColorTexture,
      layer.roughnessTexture,
      layer.occlusionTexture,
    ]),
    ...areas.map(({ texture }) => texture),
  ]
  const images = new Map<number, RgbaImage>()
  for (const index of new Set(references.flatMap((reference) => reference?.index ?? []))) {
    const texture = (await parser.getDependency('texture', index)) as Texture
    images.set(index, readTexture(texture, `${WRINKLE_MAPS} texture ${index}`))
  }
  return images
}
