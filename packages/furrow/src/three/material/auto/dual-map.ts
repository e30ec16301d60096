import type { Texture } from 'three'
import type { AnyRenderer } from '../../renderer.ts'
import { ComposedMap, composedSize, levelsOf } from '../composed-map.ts'
import type { ShaderInputs } from '../shader-inputs.ts'
import type { WrinkleTextures } from '../wrinkle-textures.ts'
import type { AutoModeHost } from './face-host.ts'
import { allocate, bytesOfMap, free } from './texture-budget.ts'

type DualMapHost = Pick<AutoModeHost, 'shaders' | 'hasContents' | 'budget'>

const maps: DualMap[] = []

const NO_ACTIVATIONS = new Float32Array(0)

/**
 * Two normals in each texel: red and green are x and y of the material's own map, blue and alpha those of the first layer. Shaders find z,
 * since both are of unit length, and read both maps by one sample. Faces with the same maps share it.
 */
export class DualMap {
  readonly #map: ComposedMap
  readonly #host: DualMapHost
  readonly #renderer: AnyRenderer
  readonly #base: Texture
  readonly #baseVersion: number
  readonly #textures: WrinkleTextures
  readonly #version: number
  readonly #bytes: number
  #users = 0
  #isDrawn = false

  private constructor(
    host: DualMapHost,
    renderer: AnyRenderer,
    base: Texture,
    textures: WrinkleTextures,
    bytes: number,
  ) {
    this.#host = host
    this.#renderer = renderer
    this.#base = base
    this.#baseVersion = base.version
    this.#textures = textures
    this.#version = textures.version
    this.#bytes = bytes
    const size = composedSize(base, textures.normals.texture)
    const format = { ...size, levels: levelsOf(size) }
    this.#map = new ComposedMap(base, format, host.shaders.dualMaterial(base, textures), host.hasContents)
    this.texture.matrixAutoUpdate = false
  }

  /** That of a face's maps; null where there is not the memory for it. Whoever has it releases it. */
  static take(
    host: DualMapHost,
    renderer: AnyRenderer,
    base: Texture,
    textures: WrinkleTextures,
  ): DualMap | null {
    let map = maps.find((known) => known.isOf(renderer, base, textures))
    if (!map) {
      const bytes = bytesOfMap(composedSize(base, textures.normals.texture), 4)
      if (!allocate(bytes, host.budget)) return null
      map = new DualMap(host, renderer, base, textures, bytes)
      maps.push(map)
    }
    map.#users++
    return map
  }

  get texture(): Texture {
    return this.#map.target.texture
  }

  /** Whether it shows these maps as they are now. */
  isOf(renderer: AnyRenderer, base: Texture, textures: WrinkleTextures): boolean {
    return (
      renderer === this.#renderer &&
      base === this.#base &&
      base.version === this.#baseVersion &&
      textures === this.#textures &&
      textures.version === this.#version &&
      !(this.#isDrawn && !this.#host.hasContents(renderer, this.#map.target))
    )
  }

  /** Draws it, if that was not done before. Outside of frames only. */
  async draw({ areas }: ShaderInputs): Promise<void> {
    await this.#map.compile(this.#renderer)
    if (this.#isDrawn || this.#users === 0) return
    this.#map.update(this.#renderer, areas, NO_ACTIVATIONS, 1, 0)
    this.#isDrawn = true
  }

  release(): void {
    if (--this.#users > 0) return
    maps.splice(maps.indexOf(this), 1)
    free(this.#bytes)
    this.#map.dispose()
  }
}
