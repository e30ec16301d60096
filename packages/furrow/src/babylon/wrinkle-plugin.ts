import type { AbstractEngine } from '@babylonjs/core/Engines/abstractEngine.js'
import type { Material } from '@babylonjs/core/Materials/material.js'
import type { MaterialDefines } from '@babylonjs/core/Materials/materialDefines.js'
import { MaterialPluginBase } from '@babylonjs/core/Materials/materialPluginBase.js'
import { ShaderLanguage } from '@babylonjs/core/Materials/shaderLanguage.js'
import type { BaseTexture } from '@babylonjs/core/Materials/Textures/baseTexture.js'
import type { UniformBuffer } from '@babylonjs/core/Materials/uniformBuffer.js'
import type { AbstractMesh } from '@babylonjs/core/Meshes/abstractMesh.js'
import type { SubMesh } from '@babylonjs/core/Meshes/subMesh.js'
import type { Scene } from '@babylonjs/core/scene.js'
import type { Cell, Vector4Like } from '../runtime/atlas-cells.ts'
import { MAP_KINDS, VALUE_KINDS, type ValueKind } from '../runtime/maps/layer-maps.ts'
import type { SkinMaterial } from './check-mesh.ts'
import {
  fragmentInjections,
  type Injections,
  type ShaderKind,
  vertexInjections,
} from './shaders/injections.ts'
import { type MixedLayers, samplerOf } from './shaders/mixing.ts'
import type { SharedSet } from './shared-set.ts'
import { isTiled } from './tiling.ts'

/** Properties of a face that the plugin needs to draw the meshes of the face. */
export interface DrawnFace {
  readonly shared: SharedSet
  readonly cells: readonly Cell[]
  /** Whether instances have the `furrowCell` attribute. */
  readonly hasCells: boolean
}

/** Names of uniforms. Each uniform is a `vec4`. */
const UNIFORMS = [
  'furrowPlace',
  'furrowInside',
  'furrowGrid',
  'furrowLimit',
  'furrowNormalScale',
  'furrowOcclusionStrength',
  'furrowBloodAmplitude',
  'furrowOnsetStrength',
] as const

/** Scratch vector with the location of a cell. */
const place: Vector4Like = { x: 0, y: 0, z: 1, w: 1 }

/** Maps the code of each shader variant to a number. This number is a define, because Babylon.js caches shaders by their defines. */
const variants = new Map<string, number>()

function variantOf(injections: Injections | null): number {
  const code = JSON.stringify(injections)
  const known = variants.get(code) ?? variants.size + 1
  variants.set(code, known)
  return known
}

const ONE = (sampler: ValueKind) => ({ slices: [0], channel: 0, sampler })
const ALL_KINDS: MixedLayers = {
  kinds: ['replace'],
  normals: [0],
  values: Object.fromEntries(VALUE_KINDS.map((kind) => [kind, ONE(kind)])),
}

/**
 * Defines of the shader. `FURROW_CELLS` is set if instances have different cells of the influence atlas. `FURROW_TILED` is set if texture
 * coordinates wrap around.
 */
const FLAGS = { FURROW_CELLS: false, FURROW_TILED: false }

/** Vertex attribute with the index of an instance's cell. */
export const CELL = 'furrowCell'

/** Material plugin for Babylon.js that draws wrinkles. Meshes that share the material can have different activations. */
export class WrinklePlugin extends MaterialPluginBase {
  static readonly NAME = 'FurrowWrinkles'
  readonly #kind: ShaderKind
  readonly #faceOf: (mesh: AbstractMesh) => DrawnFace | undefined
  #shared: SharedSet | null = null
  #fragment: Injections | null = null
  #variant = 0

  /** @param faceOf returns the face of a mesh, or undefined if the mesh has no wrinkles. */
  constructor(material: Material, kind: ShaderKind, faceOf: (mesh: AbstractMesh) => DrawnFace | undefined) {
    super(material, WrinklePlugin.NAME, 300, { FURROW: 0, ...FLAGS }, false)
    this.registerForExtraEvents = true
    this.doNotSerialize = true
    this.#kind = kind
    this.#faceOf = faceOf
    // Babylon.js collects the injection points once, when the plugin is added. At this time, the plugin must return all points that it may
    // use later.
    this.#fragment = fragmentInjections(kind, this.#isWgsl, ALL_KINDS)
    this._pluginManager._addPlugin(this)
    this._enable(true)
  }

  /** Wrinkle set that the material draws, or null if it draws none. */
  get shared(): SharedSet | null {
    return this.#shared
  }

  set shared(shared: SharedSet | null) {
    this.#shared = shared
    this.#fragment = shared && fragmentInjections(this.#kind, this.#isWgsl, shared.textures.mixed)
    this.#variant = shared ? variantOf(this.#fragment) : 0
    this.markAllDefinesAsDirty()
  }

  get #isWgsl(): boolean {
    return this._material.shaderLanguage === ShaderLanguage.WGSL
  }

  override getClassName(): string {
    return WrinklePlugin.NAME
  }

  override isCompatible(): boolean {
    return true
  }

  override isReadyForSubMesh(): boolean {
    return this.#shared?.atlas.isSettled ?? true
  }

  override prepareDefines(defines: MaterialDefines, _scene: Scene, mesh: AbstractMesh): void {
    defines.FURROW = this.#variant
    const face = this.#shared && this.#faceOf(mesh)
    defines.FURROW_CELLS = Boolean(defines.INSTANCES) && (face?.hasCells ?? false)
    const { bumpTexture } = this._material as SkinMaterial
    const isWrapped = Boolean(face && bumpTexture && isTiled(mesh, bumpTexture))
    if (isWrapped === defines.FURROW_TILED) return
    defines.FURROW_TILED = isWrapped
    // Babylon.js does not notice when a page changes the transform of the normal map.
    defines.markAsUnprocessed()
  }

  override getAttributes(attributes: string[], _scene: Scene, mesh: AbstractMesh): void {
    if (this.#faceOf(mesh)?.hasCells) attributes.push(CELL)
  }

  override getSamplers(samplers: string[]): void {
    // Babylon.js calls this method only once, so samplers for all kinds of maps are listed. The material may draw another set later.
    samplers.push('furrowInfluenceMap')
    for (const kind of MAP_KINDS) {
      samplers.push(samplerOf(kind))
    }
  }

  override getUniforms(language = ShaderLanguage.GLSL) {
    return {
      ubo: UNIFORMS.map((name) => ({ name, size: 4, type: 'vec4' })),
      // Engines without uniform buffers need declarations of the uniforms.
      ...(language === ShaderLanguage.GLSL && {
        fragment: UNIFORMS.map((name) => `uniform vec4 ${name};`).join('\n'),
      }),
    }
  }

  override getCustomCode(shaderType: string, language = ShaderLanguage.GLSL): Injections | null {
    if (!this.#fragment) return null
    return shaderType === 'vertex' ? vertexInjections(language === ShaderLanguage.WGSL) : this.#fragment
  }

  override hardBindForSubMesh(
    uniforms: UniformBuffer,
    _scene: Scene,
    _engine: AbstractEngine,
    subMesh: SubMesh,
  ): void {
    const shared = this.#shared
    if (!shared) return
    const face = this.#faceOf(subMesh.getMesh())
    const { cells } = shared.atlas
    const { grid, inside, width, height } = cells
    cells.locate(face?.cells[0].index ?? 0, place)
    setVector(uniforms, 'furrowPlace', place)
    setVector(uniforms, 'furrowInside', inside)
    uniforms.updateFloat4('furrowGrid', grid.columns, grid.rows, 0.5 / width, 0.5 / height)
    // A limit of 0 turns influence off for meshes without wrinkles that use the same material.
    uniforms.updateFloat4('furrowLimit', face ? 1 : 0, 0, 0, 0)
    const { textures, normalScale, occlusionStrength, bloodAmplitude, onsetStrength } = shared.textures
    setFour(uniforms, 'furrowNormalScale', normalScale)
    setFour(uniforms, 'furrowOcclusionStrength', occlusionStrength)
    setFour(uniforms, 'furrowBloodAmplitude', bloodAmplitude)
    setFour(uniforms, 'furrowOnsetStrength', onsetStrength)
    uniforms.setTexture('furrowInfluenceMap', shared.atlas.map)
    for (const kind in textures) {
      uniforms.setTexture(samplerOf(kind as 'normal'), textures[kind as 'normal']!)
    }
  }

  override hasTexture(texture: BaseTexture): boolean {
    return Object.values(this.#shared?.textures.textures ?? {}).includes(texture as never)
  }
}

function setVector(uniforms: UniformBuffer, name: string, { x, y, z, w }: Readonly<Vector4Like>): void {
  uniforms.updateFloat4(name, x, y, z, w)
}

function setFour(uniforms: UniformBuffer, name: string, [x, y, z, w]: readonly number[]): void {
  uniforms.updateFloat4(name, x, y, z, w)
}
