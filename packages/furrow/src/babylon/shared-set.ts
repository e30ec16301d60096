import type { Scene } from '@babylonjs/core/scene.js'
import type { Area, Layer } from '../core/types.ts'
import { type AreaSlices, packSlices } from './influence/area-slices.ts'
import { InfluenceAtlas } from './influence/influence-atlas.ts'
import { createTextures, type LayerTextures } from './layer-textures.ts'
import { sceneFrame } from './scene-frame.ts'

/** Areas, textures and influence atlas of a wrinkle set. All faces with this set in a scene share them. */
export class SharedSet {
  readonly scene: Scene
  readonly areas: readonly Area[]
  readonly slices: AreaSlices
  readonly textures: LayerTextures
  readonly atlas: InfluenceAtlas
  #users = 0

  /**
   * @param areaSize width and height to which areas are resampled, in texels.
   * @param anisotropy anisotropic filtering level of the textures.
   * @throws FurrowError if maps of one kind differ in size.
   */
  constructor(
    { layers, areas }: { layers: readonly Layer[]; areas: readonly Area[] },
    areaSize: number,
    anisotropy: number,
    scene: Scene,
  ) {
    this.scene = scene
    this.areas = areas.map((area) => ({ ...area }))
    this.slices = packSlices(areas, layers, areaSize)
    this.textures = createTextures(layers, anisotropy, scene)
    this.atlas = new InfluenceAtlas(this.slices, scene)
    sceneFrame(scene).targets.push(this.atlas)
  }

  retain(): void {
    this.#users++
  }

  /** Unregisters a face. Frees all textures when no face is left. */
  release(): void {
    if (--this.#users > 0) return
    const { targets } = sceneFrame(this.scene)
    targets.splice(targets.indexOf(this.atlas), 1)
    this.atlas.dispose()
    for (const texture of Object.values(this.textures.textures)) texture.dispose()
  }
}
