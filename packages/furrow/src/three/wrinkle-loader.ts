import type { Mesh } from 'three'
import type { GLTF, GLTFParser } from 'three/addons/loaders/GLTFLoader.js'
import type { WrinkleSet } from '../core/types.ts'
import { WRINKLE_MAPS } from '../core/wrinkle-maps.ts'
import { driveByMorphs } from './drive.ts'
import { readWrinkleMaps } from './read-wrinkle-maps.ts'
import type { WrinklesBase } from './Wrinkles.ts'

/** A renderer's class of wrinkles. */
type WrinklesClass = new (mesh: Mesh, set: WrinkleSet) => WrinklesBase

/**
 * Puts the wrinkles of FURROW_wrinkle_maps on what `GLTFLoader` loads. A loaded face wrinkles by itself as its
 * blendshapes move: nothing is to be called in the render loop. The wrinkles stand in `gltf.userData.wrinkles`,
 * one for each material that has them, to be switched, looked at or disposed of.
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
    const wrinkles: WrinklesBase[] = []
    try {
      for (const { mesh, set, drivers } of await readWrinkleMaps(gltf, this.#parser)) {
        const own = new this.#Wrinkles(mesh, set)
        wrinkles.push(own)
        driveByMorphs(own, drivers)
      }
    } catch (error) {
      for (const own of wrinkles) own.dispose()
      throw error
    }
    if (wrinkles.length > 0) gltf.userData.wrinkles = wrinkles
  }
}
