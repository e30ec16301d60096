import type { Material, Texture } from 'three'
import type { AnyRenderer } from '../../renderer.ts'
import { ComposedMap, composedSize, levelsOf } from '../composed-map.ts'
import type { ShaderInputs } from '../shader-inputs.ts'
import type { WrinkleTextures } from '../wrinkle-textures.ts'
import type { AutoModeHost } from './face-host.ts'
import { type FirstValues, firstValues } from './first-values.ts'
import { OwnMaps } from './own-maps.ts'
import type { ReplacingMaps } from './standby-program.ts'
import { allocate, bytesOfMap, free } from './texture-budget.ts'

type DualMapHost = Pick<AutoModeHost, 'shaders' | 'hasContents' | 'budget'>

const maps: DualMap[] = []

const NO_ACTIVATIONS = new Float32Array(0)

/**
 * Two normals in each texel: red and green are x and y of the material's own map, blue and alpha those of the first layer. Shaders find z,
 * since both are of unit length, and read both maps by one sample. Where the material has a map of occlusion, another one takes its place,
 * which holds the first layer's visibility and blood too, behind red. Faces with the same maps share both.
 */
export class DualMap {
  readonly #host: DualMapHost
  readonly #renderer: AnyRenderer
  readonly #own: OwnMaps
  readonly #textures: WrinkleTextures
  readonly #version: number
  readonly #bytes: number
  /** Takes the place of the material's own. */
  readonly maps: ReplacingMaps
  readonly #normals: ComposedMap
  readonly #values: ComposedMap | null
  #users = 0
  #isDrawn = false

  private constructor(
    host: DualMapHost,
    renderer: AnyRenderer,
    own: OwnMaps,
    textures: WrinkleTextures,
    values: FirstValues | null,
    bytes: number,
  ) {
    const { base, aoMap } = own
    const { shaders, hasContents } = host
    const create = (map: Texture, layers: Texture, material: Material) => {
      const size = composedSize(map, layers)
      const created = new ComposedMap(map, { ...size, levels: levelsOf(size) }, material, hasContents)
      created.target.texture.matrixAutoUpdate = false
      return created
    }
    this.#host = host
    this.#renderer = renderer
    this.#own = own
    this.#textures = textures
    this.#version = textures.version
    this.#bytes = bytes
    this.#normals = create(base, textures.normals.texture, shaders.dualMaterial(base, textures))
    this.#values = aoMap && values && create(aoMap, values.texture, shaders.valuesMaterial(aoMap, values))
    this.maps = { normals: this.#normals.target.texture, occlusion: this.#values?.target.texture ?? null }
  }

  /**
   * Those of a face's maps; null where there is not the memory for them. Whoever has them releases them.
   *
   * @param aoMap the material's map of occlusion, if that of the values takes its place; else null.
   */
  static take(
    host: DualMapHost,
    renderer: AnyRenderer,
    base: Texture,
    aoMap: Texture | null,
    textures: WrinkleTextures,
  ): DualMap | null {
    let map = maps.find((known) => known.isOf(renderer, base, aoMap, textures))
    if (!map) {
      const values = aoMap && firstValues(textures)
      const beside = aoMap && values ? bytesOf(aoMap, values.texture) : 0
      const bytes = bytesOf(base, textures.normals.texture) + beside
      if (!allocate(bytes, host.budget)) return null
      map = new DualMap(host, renderer, new OwnMaps(base, aoMap), textures, values, bytes)
      maps.push(map)
    }
    map.#users++
    return map
  }

  /** Whether it shows these maps as they are now. */
  isOf(renderer: AnyRenderer, base: Texture, aoMap: Texture | null, textures: WrinkleTextures): boolean {
    return (
      renderer === this.#renderer &&
      this.#own.are(base, aoMap) &&
      textures === this.#textures &&
      textures.version === this.#version &&
      !(this.#isDrawn && !this.#hasContents)
    )
  }

  get #hasContents(): boolean {
    const { hasContents } = this.#host
    const hasNormals = hasContents(this.#renderer, this.#normals.target)
    return hasNormals && (!this.#values || hasContents(this.#renderer, this.#values.target))
  }

  /** Draws it, if that was not done before. Outside of frames only. */
  async draw({ areas }: ShaderInputs): Promise<void> {
    await this.#normals.compile(this.#renderer)
    if (this.#users > 0) await this.#values?.compile(this.#renderer)
    if (this.#isDrawn || this.#users === 0) return
    this.#normals.update(this.#renderer, areas, NO_ACTIVATIONS, 1, 0)
    this.#values?.update(this.#renderer, areas, NO_ACTIVATIONS, 1, 0)
    this.#isDrawn = true
  }

  release(): void {
    if (--this.#users > 0) return
    maps.splice(maps.indexOf(this), 1)
    free(this.#bytes)
    this.#normals.dispose()
    this.#values?.dispose()
  }
}

/** Of a map as large as the larger of two. */
function bytesOf(own: Texture, layers: Texture): number {
  return bytesOfMap(composedSize(own, layers), 4)
}
