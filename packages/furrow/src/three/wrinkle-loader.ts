import type { Material, Mesh, Texture } from 'three'
import type { GLTF, GLTFParser } from 'three/addons/loaders/GLTFLoader.js'
import type { Area, Layer, WrinkleSet } from '../core/types.ts'
import { parseWrinkleMaps, WRINKLE_MAPS, type WrinkleMaps } from '../core/wrinkle-maps.ts'
import { driveByMorphs } from './drive.ts'
import { readTexture } from './read-texture.ts'
import type { WrinklesBase } from './Wrinkles.ts'

/** A renderer's class of wrinkles. */
type WrinklesClass = new (mesh: Mesh, set: WrinkleSet) => WrinklesBase

/**
 * Reads FURROW_wrinkle_maps for three.js's `GLTFLoader`. A loaded face wrinkles by itself as its blendshapes move:
 * nothing is to be called in the render loop. The wrinkles stand in `gltf.userData.wrinkles`, one for each
 * material that has them, to be switched, looked at or disposed of.
 */
export class WrinkleLoader {
  readonly name = WRINKLE_MAPS
  readonly #parser: GLTFParser
  readonly #Wrinkles: WrinklesClass

  constructor(parser: GLTFParser, Wrinkles: WrinklesClass) {
    this.#parser = parser
    this.#Wrinkles = Wrinkles
  }

  /** Called by the loader when all else is there. Rejects with a FurrowError where the extension is malformed. */
  async afterRoot(gltf: GLTF): Promise<void> {
    const owners = new Map<Material, Mesh>()
    for (const scene of gltf.scenes) {
      scene.traverse((object) => {
        const mesh = object as Mesh
        const material = mesh.material as Material
        // Primitives that share a material share its wrinkles; the first of them drives.
        if (mesh.isMesh && this.#extensionOf(material) && !owners.has(material)) owners.set(material, mesh)
      })
    }
    const sets = new Map<object, Promise<WrinkleSet>>()
    const wrinkles: WrinklesBase[] = []
    try {
      for (const [material, mesh] of owners) {
        const json = this.#extensionOf(material)!
        const maps = parseWrinkleMaps(json, this.#parser.json.textures?.length ?? 0)
        // Materials that the loader cloned from one of the file share what was read for it.
        if (!sets.has(json)) sets.set(json, this.#readSet(maps))
        const own = new this.#Wrinkles(mesh, await sets.get(json)!)
        wrinkles.push(own)
        own.onDispose(driveByMorphs(own, mesh, maps.drivers))
      }
    } catch (error) {
      for (const own of wrinkles) own.dispose()
      throw error
    }
    if (wrinkles.length > 0) gltf.userData.wrinkles = wrinkles
  }

  #extensionOf(material: Material): object | undefined {
    const index = this.#parser.associations.get(material)?.materials
    return index === undefined ? undefined : this.#parser.json.materials[index].extensions?.[WRINKLE_MAPS]
  }

  async #readSet(maps: WrinkleMaps): Promise<WrinkleSet> {
    const images = new Map<number, ReturnType<typeof readTexture>>()
    const indices = [
      ...maps.layers.map(({ normalTexture }) => normalTexture.index),
      ...maps.areas.map(({ texture }) => texture.index),
    ]
    for (const index of new Set(indices)) {
      const texture = (await this.#parser.getDependency('texture', index)) as Texture
      images.set(index, readTexture(texture, `${WRINKLE_MAPS} texture ${index}`))
    }
    const layers = maps.layers.map(
      ({ name, kind, normalTexture }): Layer => ({
        name,
        kind,
        normal: images.get(normalTexture.index)!,
        normalScale: normalTexture.scale,
      }),
    )
    const areas = maps.areas.map(({ name, layer, texture, channel, combine, activation }): Area => {
      const { width, height, data } = images.get(texture.index)!
      const weights = Uint8Array.from({ length: width * height }, (_, i) => data[4 * i + channel])
      return {
        name,
        layer: layers[layer].name,
        combine,
        activation,
        weights: { width, height, data: weights },
      }
    })
    return { layers, areas }
  }
}
