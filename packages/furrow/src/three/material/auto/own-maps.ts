import type { Texture } from 'three'

/** A material's own maps, as they were when others were made from them. */
export class OwnMaps {
  readonly base: Texture
  readonly aoMap: Texture | null
  readonly #baseVersion: number
  readonly #aoVersion: number | undefined

  /**
   * @param base its normal map.
   * @param aoMap null where nothing is made from it.
   */
  constructor(base: Texture, aoMap: Texture | null) {
    this.base = base
    this.aoMap = aoMap
    this.#baseVersion = base.version
    this.#aoVersion = aoMap?.version
  }

  /** Whether these are the maps, and have not changed. */
  are(base: Texture, aoMap: Texture | null): boolean {
    const isBase = base === this.base && base.version === this.#baseVersion
    return isBase && aoMap === this.aoMap && aoMap?.version === this.#aoVersion
  }
}
