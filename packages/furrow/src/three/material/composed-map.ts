import {
  LinearFilter,
  LinearMipmapLinearFilter,
  type Material,
  NearestFilter,
  OrthographicCamera,
  RenderTarget,
  Scene,
  type Texture,
} from 'three'
import { type Bounds, widen } from '../../core/bounds.ts'
import type { AreaSlot } from '../../runtime/area-slots.ts'
import { hasMoved } from '../../runtime/atlas-cells.ts'
import type { AreaArray } from '../atlas/area-array.ts'
import type { QuadMaterials } from '../atlas/quad-materials.ts'
import { Quads } from '../atlas/quads.ts'
import { renderPreservingState } from '../atlas/render-preserving-state.ts'
import type { AnyRenderer } from '../renderer.ts'
import type { ShaderInputs } from './shader-inputs.ts'
import { copyUvTransform } from './textures.ts'

/** Rectangle that covers the complete composed map. `Quads` draws it to redraw the complete map. */
const FULL: AreaSlot = {
  layer: 0,
  combine: 'sum',
  slice: 0,
  channel: 0,
  bounds: { x0: 0, y0: 0, x1: 1, y1: 1 },
}

/** Size in texels. */
export interface Size {
  width: number
  height: number
}

/**
 * Creates a material that draws the composed normal map with `Quads`. The composed map is `base`, mixed with the normals of the wrinkles.
 *
 * @param level mip level that is drawn. The shader reads one texel of each map for each texel of the level. Undefined if the maps differ in
 *   size; the shader then filters the maps.
 */
export type ComposeMaterial = (base: Texture, inputs: ShaderInputs, level?: Level) => Material

/** Uniform with the mip level that is drawn, 0 = finest. */
export interface Level {
  value: number
}

/** Size and mip levels of a composed normal map. */
export interface ComposedFormat extends Size {
  /** Uniform with the mip level that the material draws; undefined if the maps differ in size. */
  level?: Level | undefined
  /**
   * Number of mip levels to draw. If it is 1 (default), only the finest level is drawn, and the GPU generates the other levels from it.
   * If it is larger, each level is mixed from the same level of the layers' maps. The results of the two methods differ by at most two 8-bit
   * steps.
   */
  levels?: number
}

/**
 * Chooses the size and mip levels of a composed normal map.
 *
 * @param normals normal maps of the layers.
 * @param drawsLevels whether to draw all mip levels. Has no effect unless `base` and `normals` have mipmaps and the same size.
 */
export function composedFormat(base: Texture, normals: Texture, drawsLevels: boolean): ComposedFormat {
  const [baseSize, layerSize] = sizesOf(base, normals)
  const size = composedSize(base, normals)
  if (baseSize.width !== layerSize.width || baseSize.height !== layerSize.height) return size
  const levels = levelsOf(size)
  const isDrawn = drawsLevels && hasLevels(base, levels) && hasLevels(normals, levels)
  return { ...size, level: { value: 0 }, levels: isDrawn ? levels : 1 }
}

function levelsOf({ width, height }: Size): number {
  return 1 + Math.floor(Math.log2(Math.max(width, height)))
}

function hasLevels({ generateMipmaps, minFilter, mipmaps }: Texture, levels: number): boolean {
  const isMipmapped = minFilter !== LinearFilter && minFilter !== NearestFilter
  return isMipmapped && (generateMipmaps || mipmaps!.length === levels)
}

export function composedSize(base: Texture, normals: Texture): Size {
  const [baseSize, layerSize] = sizesOf(base, normals)
  return {
    width: Math.max(baseSize.width, layerSize.width),
    height: Math.max(baseSize.height, layerSize.height),
  }
}

function sizesOf(...maps: Texture[]): Size[] {
  return maps.map(({ image }) => image as Size)
}

/**
 * A face's normal map with its wrinkles mixed in, drawn in UV space when activations change. An activation, 0..1, is the current strength of
 * an area, i.e. of a group of wrinkles. The composed map replaces the normal map of the material, so wrinkles also work on materials whose
 * shader cannot be patched.
 */
export class ComposedMap {
  readonly target: RenderTarget
  /** Normal map of the material. The composed map replaces it. */
  readonly base: Texture
  readonly #quads: Quads
  readonly #scene = new Scene()
  readonly #camera = new OrthographicCamera()
  readonly #hasContents: QuadMaterials['hasContents']
  #renderer: AnyRenderer | null = null
  #areas: AreaArray | null = null
  #fade = 1
  #version = 0
  readonly #levels: number
  readonly #level: Level | undefined
  #slots: AreaSlot[] = []
  readonly #span: AreaSlot = { ...FULL, bounds: { ...FULL.bounds } }
  #drawn = new Float32Array(0)

  /**
   * @param base normal map to replace. The composed map has the same wrapping, anisotropy, UV channel and transform.
   * @param material draws the composed map, see `ComposeMaterial`.
   */
  constructor(
    base: Texture,
    { width, height, levels = 1, level }: ComposedFormat,
    material: Material,
    hasContents: QuadMaterials['hasContents'],
  ) {
    this.base = base
    this.#levels = levels
    this.#level = level
    this.target = new RenderTarget(width, height, {
      depthBuffer: false,
      generateMipmaps: levels === 1,
      magFilter: LinearFilter,
      minFilter: LinearMipmapLinearFilter,
      anisotropy: base.anisotropy,
      wrapS: base.wrapS,
      wrapT: base.wrapT,
    })
    const { texture } = this.target
    // three.js allocates one mip level per item of `mipmaps`.
    if (levels > 1) texture.mipmaps = Array.from({ length: levels }, () => ({})) as typeof texture.mipmaps
    copyUvTransform(texture, base)
    this.#hasContents = hasContents
    this.#quads = new Quads({ width: 1, height: 1, grid: { columns: 1, rows: 1 } }, material)
    this.#scene.matrixWorldAutoUpdate = false
    this.#scene.add(this.#quads.mesh)
  }

  /**
   * Redraws the areas whose activations have changed. Redraws the complete map if `areas`, `fade` or `version` have changed, or if the map
   * has lost its contents. The influence map must be up to date.
   *
   * @param values activations in the order of the areas.
   * @param fade opacity of all wrinkles, 0..1.
   * @param version number that changes when weights of areas or maps of layers change.
   */
  update(renderer: AnyRenderer, areas: AreaArray, values: Float32Array, fade: number, version: number): void {
    this.#quads.begin()
    const isOutdated = this.#isOutdated(renderer) || areas !== this.#areas || version !== this.#version
    if (isOutdated || fade !== this.#fade) this.#putAll(areas, values)
    else this.#putMoved(values)
    this.#fade = fade
    this.#version = version
    this.#quads.end()
    if (!this.#quads.mesh.visible) return
    for (let level = 0; level < this.#levels; level++) {
      // `WebGPURenderer` scales the viewport per level itself.
      const halvings = 'isWebGLRenderer' in renderer ? level : 0
      const [width, height] = [this.target.width >> halvings, this.target.height >> halvings]
      this.target.viewport.set(0, 0, Math.max(1, width), Math.max(1, height))
      if (this.#level) this.#level.value = level
      renderPreservingState(renderer, this.target, this.#scene, this.#camera, level)
    }
  }

  dispose(): void {
    this.target.dispose()
    this.#quads.dispose()
  }

  #isOutdated(renderer: AnyRenderer): boolean {
    const isOutdated = renderer !== this.#renderer || !this.#hasContents(renderer, this.target)
    this.#renderer = renderer
    return isOutdated
  }

  #putAll(areas: AreaArray, values: Float32Array): void {
    this.#areas = areas
    this.#slots = areas.slots.map((slot) => reachOf(slot, areas))
    this.#drawn = values.slice(0, areas.slots.length)
    this.#quads.put(0, 0, FULL, 0)
  }

  /**
   * Adds the rectangles of areas whose activations have changed. Overlapping rectangles may cover more texels in total than their bounding
   * rectangle; the bounding rectangle is then added instead.
   */
  #putMoved(values: Float32Array): void {
    const { bounds } = this.#span
    bounds.x0 = bounds.y0 = 1
    bounds.x1 = bounds.y1 = 0
    let sum = 0
    for (let i = 0; i < this.#slots.length; i++) {
      if (!hasMoved(values[i], this.#drawn[i])) continue
      this.#drawn[i] = values[i]
      const slot = this.#slots[i]
      this.#quads.put(0, 0, slot, 0)
      widen(bounds, slot.bounds)
      sum += sizeOf(slot.bounds)
    }
    if (sizeOf(bounds) >= sum) return
    this.#quads.begin()
    this.#quads.put(0, 0, this.#span, 0)
  }
}

/** Converts the bounds of an area to 0..1. Extends them by one texel on each side, because bilinear filtering reads neighbouring texels. */
function reachOf(slot: AreaSlot, { width, height }: AreaArray): AreaSlot {
  const { x0, y0, x1, y1 } = slot.bounds
  const bounds = {
    x0: Math.max(0, x0 - 1) / width,
    y0: Math.max(0, y0 - 1) / height,
    x1: Math.min(width, x1 + 1) / width,
    y1: Math.min(height, y1 + 1) / height,
  }
  return { ...slot, bounds }
}

function sizeOf({ x0, y0, x1, y1 }: Bounds): number {
  return (x1 - x0) * (y1 - y0)
}
