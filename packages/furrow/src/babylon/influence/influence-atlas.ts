import { Constants } from '@babylonjs/core/Engines/constants.js'
import type { RenderTargetWrapper } from '@babylonjs/core/Engines/renderTargetWrapper.js'
import { EffectRenderer, EffectWrapper } from '@babylonjs/core/Materials/effectRenderer.js'
import { ShaderLanguage } from '@babylonjs/core/Materials/shaderLanguage.js'
import { RawTexture } from '@babylonjs/core/Materials/Textures/rawTexture.js'
import type { Texture } from '@babylonjs/core/Materials/Textures/texture.js'
import { ThinTexture } from '@babylonjs/core/Materials/Textures/thinTexture.js'
import type { Scene } from '@babylonjs/core/scene.js'
import { AtlasCells, type Cell } from '../../runtime/atlas-cells.ts'
import type { Face } from '../../runtime/face.ts'
import type { InfluenceTarget } from '../../runtime/frame.ts'
import { areaTexture } from '../textures.ts'
import type { AreaSlices } from './area-slices.ts'
import { GLSL, SAMPLERS, UNIFORMS, WGSL } from './influence-shader.ts'

/** If the shader reads this value instead of the number of active areas, it does not redraw the cell. */
const KEEP = -1

/**
 * Texture atlas with the influence maps of all faces that share a wrinkle set. Each face has one cell. An influence map contains, for each
 * layer, the sum of `weight * activation` over the layer's areas. One draw call redraws all cells in which an activation has changed.
 *
 * The sum leaves out areas that combine by `max`. A texel stores the larger of two values: the maximum over these areas, and the sum over all
 * other areas. The stored half float is not clamped. Shaders clamp to 1 after interpolation, like the reference implementation.
 */
export class InfluenceAtlas implements InfluenceTarget<Scene> {
  readonly cells: AtlasCells
  readonly #areas: AreaSlices
  readonly #scene: Scene
  readonly #texture: Texture
  readonly #renderer: EffectRenderer
  readonly #effect: EffectWrapper
  readonly #columns: number
  #target!: RenderTargetWrapper
  #map!: ThinTexture
  #table!: RawTexture
  #rows!: Float32Array
  readonly #restored: { remove(): void }

  constructor(areas: AreaSlices, scene: Scene) {
    const engine = scene.getEngine()
    this.#areas = areas
    this.#scene = scene
    this.cells = new AtlasCells(areas.width, areas.height)
    this.#columns = Math.max(2 * areas.slots.length, 1 + areas.slots.length)
    this.#texture = areaTexture(areas.images, scene)
    this.#renderer = new EffectRenderer(engine)
    const { vertex, fragment } = engine.isWebGPU ? WGSL : GLSL
    this.#effect = new EffectWrapper({
      engine,
      name: 'furrow influence',
      vertexShader: vertex,
      fragmentShader: fragment,
      attributeNames: ['position'],
      uniformNames: UNIFORMS,
      samplerNames: SAMPLERS,
      shaderLanguage: engine.isWebGPU ? ShaderLanguage.WGSL : ShaderLanguage.GLSL,
    })
    this.#effect.onApplyObservable.add(() => {
      const { effect } = this.#effect
      const { width, height, grid } = this.cells
      effect.setFloat4('furrowSize', width, height, grid.columns, grid.rows)
      effect.setTexture('furrowAreas', this.#texture)
      effect.setTexture('furrowTable', this.#table)
    })
    const restored = engine.onContextRestoredObservable.add(() => this.cells.invalidate())
    this.#restored = { remove: () => engine.onContextRestoredObservable.remove(restored) }
    this.#resize()
  }

  /** Whether compilation of the shader has finished. If it has failed, faces are drawn without wrinkles. */
  get isSettled(): boolean {
    return this.#effect.isReady() || this.#effect.effect.getCompilationError() !== ''
  }

  /** Texture with all cells. */
  get map(): ThinTexture {
    return this.#map
  }

  /**
   * Allocates consecutive cells for faces.
   *
   * @throws FurrowError if the cells do not fit into the largest texture.
   */
  add(faces: readonly Face[]): Cell[] {
    const { columns, rows } = this.cells.grid
    const added = this.cells.add(faces)
    const { grid } = this.cells
    if (grid.columns !== columns || grid.rows !== rows) {
      this.#release()
      this.#resize()
    }
    return added
  }

  /** Draws all cells that `cells.collect` has marked as changed. */
  draw(): void {
    const { changed, changes } = this.cells
    this.cells.changes = 0
    // Until the shader is ready, changed cells are not drawn. The next frame collects them again.
    if (changes === 0 || !this.#effect.isReady()) return
    const engine = this.#scene.getEngine()
    engine.setAlphaMode(Constants.ALPHA_DISABLE)
    for (let i = 0; i < changes; i++) this.#write(changed[i])
    this.#table.update(this.#rows)
    this.#renderer.render(this.#effect, this.#target)
    for (let i = 0; i < changes; i++) this.#rows[this.#rowOf(changed[i])] = KEEP
  }

  dispose(): void {
    this.#restored.remove()
    this.#release()
    this.#texture.dispose()
    this.#effect.dispose()
    this.#renderer.dispose()
  }

  #rowOf({ index }: Cell): number {
    return 4 * this.#columns * (1 + index)
  }

  #write(cell: Cell): void {
    const { face, drawn } = cell
    const { values } = face.activations
    const { slots, version } = this.#areas
    const row = this.#rowOf(cell)
    let count = 0
    for (let i = 0; i < slots.length; i++) {
      drawn[i] = values[i]
      if (values[i] === 0) continue
      const at = row + 4 * ++count
      this.#rows[at] = i
      this.#rows[at + 1] = values[i]
    }
    this.#rows[row] = count
    cell.version = version
  }

  #resize(): void {
    const { width, height, grid } = this.cells
    const { columns, rows } = grid
    const engine = this.#scene.getEngine()
    this.#target = engine.createRenderTargetTexture(
      { width: columns * width, height: rows * height },
      {
        generateDepthBuffer: false,
        generateMipMaps: false,
        type: Constants.TEXTURETYPE_HALF_FLOAT,
        format: Constants.TEXTUREFORMAT_RGBA,
        samplingMode: Constants.TEXTURE_BILINEAR_SAMPLINGMODE,
        label: 'furrow influence',
      },
    )
    this.#map = new ThinTexture(this.#target.texture)
    // Filtering must be bilinear, as in the reference implementation.
    this.#map.anisotropicFilteringLevel = 1
    this.#map.wrapU = this.#map.wrapV = Constants.TEXTURE_CLAMP_ADDRESSMODE
    this.#rows = new Float32Array(4 * this.#columns * (1 + columns * rows))
    this.#writeSettings()
    for (let i = 0; i < columns * rows; i++) this.#rows[4 * this.#columns * (1 + i)] = KEEP
    this.#table = new RawTexture(
      this.#rows,
      this.#columns,
      1 + columns * rows,
      Constants.TEXTUREFORMAT_RGBA,
      this.#scene,
      false,
      false,
      Constants.TEXTURE_NEAREST_SAMPLINGMODE,
      Constants.TEXTURETYPE_FLOAT,
    )
  }

  #writeSettings(): void {
    for (const [i, { bounds, slice, layer, combine }] of this.#areas.slots.entries()) {
      const { x0, y0, x1, y1 } = bounds
      this.#rows.set([x0, y0, x1, y1, slice, layer + (combine === 'max' ? 4 : 0)], 8 * i)
    }
  }

  #release(): void {
    this.#map.dispose()
    this.#target.dispose()
    this.#table.dispose()
  }
}
