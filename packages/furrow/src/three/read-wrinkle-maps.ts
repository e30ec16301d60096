import type { Material, Mesh, Texture } from 'three'
import type { GLTF } from 'three/addons/loaders/GLTFLoader.js'
import type { Area, Layer, RgbaImage, WrinkleSet } from '../core/types.ts'
import { parseWrinkleMaps, WRINKLE_MAPS, type WrinkleDriver, type WrinkleMaps } from '../core/wrinkle-maps.ts'
import { readTexture } from './read-texture.ts'

/** What a file says of one material's wrinkles. */
export interface LoadedWrinkles {
  /** The first mesh with that material; others with it show the same wrinkles. */
  mesh: Mesh
  set: WrinkleSet
  drivers: WrinkleDriver[]
}

type Parser = GLTF['parser']

/**
 * Reads FURROW_wrinkle_maps from a file that three.js's `GLTFLoader` has loaded, one entry for each material that
 * has it. Plain data, for whatever renderer; `WrinkleLoaderPlugin` does it by itself.
 *
 * @throws FurrowError where the extension is malformed or an image cannot be read.
 */
export async function readWrinkleMaps(gltf: GLTF, parser: Parser = gltf.parser): Promise<LoadedWrinkles[]> {
  const found: LoadedWrinkles[] = []
  const sets = new Map<object, Promise<WrinkleSet>>()
  for (const [material, mesh] of firstMeshes(gltf)) {
    const json = extensionOf(material, parser)
    if (!json) continue
    const maps = parseWrinkleMaps(json, parser.json.textures?.length ?? 0)
    // Materials that the loader cloned from one of the file share what was read for it.
    if (!sets.has(json)) sets.set(json, readSet(maps, parser))
    found.push({ mesh, set: await sets.get(json)!, drivers: maps.drivers })
  }
  return found
}

function firstMeshes(gltf: GLTF): Map<Material, Mesh> {
  const owners = new Map<Material, Mesh>()
  for (const scene of gltf.scenes) {
    scene.traverse((object) => {
      const mesh = object as Mesh
      const material = mesh.material as Material
      if (mesh.isMesh && !owners.has(material)) owners.set(material, mesh)
    })
  }
  return owners
}

function extensionOf(material: Material, parser: Parser): object | undefined {
  const index = parser.associations.get(material)?.materials
  return index === undefined ? undefined : parser.json.materials[index].extensions?.[WRINKLE_MAPS]
}

async function readSet(maps: WrinkleMaps, parser: Parser): Promise<WrinkleSet> {
  const images = new Map<number, RgbaImage>()
  const references = [
    ...maps.layers.map((layer) => layer.normalTexture),
    ...maps.areas.map((area) => area.texture),
  ]
  for (const index of new Set(references.map((reference) => reference.index))) {
    const texture = (await parser.getDependency('texture', index)) as Texture
    images.set(index, readTexture(texture, `${WRINKLE_MAPS} texture ${index}`))
  }
  const layers = maps.layers.map(
    ({ name, kind, normalTexture: { index, scale } }): Layer => ({
      name,
      kind,
      normal: images.get(index)!,
      normalScale: scale,
    }),
  )
  const areas = maps.areas.map(({ name, layer, texture, channel, combine, activation }): Area => {
    const { width, height, data } = images.get(texture.index)!
    const weights = Uint8Array.from({ length: width * height }, (_, i) => data[4 * i + channel])
    return { name, layer: layers[layer].name, combine, activation, weights: { width, height, data: weights } }
  })
  return { layers, areas }
}
