import { type Material, type Mesh, ObjectSpaceNormalMap, type Texture } from 'three'
import { FurrowError } from '../../core/error.ts'
import { checkNotInstanced } from '../check-mesh.ts'
import { instancesOf } from '../instances.ts'
import type { WrinkleMode } from '../options.ts'
import { ActivationTable } from './activation-table.ts'
import { ComposedMap } from './composed-map.ts'
import { packPaperArray } from './paper-array.ts'
import type { RendererParts } from './renderer-parts.ts'
import type { ShaderInputs } from './shader-inputs.ts'
import { flatNormalTexture } from './textures.ts'
import type { WrinkleMaterial } from './wrinkle-material.ts'

const patchedMaterials = new WeakSet<Material>()

/**
 * The material of a mesh.
 *
 * @throws FurrowError, which names the mesh, when it cannot be patched or is patched already.
 */
export function checkMaterial(mesh: Mesh): WrinkleMaterial {
  const material = mesh.material as WrinkleMaterial
  const problem = problemOf(material)
  if (!problem) return material
  throw new FurrowError({ who: 'Wrinkles', value: mesh.name, ...problem })
}

/** The user's own material while it shows wrinkles. */
export class PatchedMaterial {
  mode: WrinkleMode = 'off'
  /** Replaces the material's own normal map in the composed mode. */
  composed: ComposedMap | null = null
  readonly #mesh: Mesh
  readonly #material: WrinkleMaterial
  readonly #inputs: ShaderInputs
  readonly #renderer: RendererParts
  /** The normal map of a material that has none. */
  readonly #flat: Texture | null
  #unpatch: () => void = () => {}

  constructor(mesh: Mesh, material: WrinkleMaterial, inputs: ShaderInputs, renderer: RendererParts) {
    this.#mesh = mesh
    this.#material = material
    this.#inputs = inputs
    this.#renderer = renderer
    this.#flat = material.normalMap ? null : flatNormalTexture()
    if (this.#flat) material.normalMap = this.#flat
    patchedMaterials.add(material)
  }

  /**
   * Changes the mode.
   *
   * @throws FurrowError when the mode is not possible; it then stays as it was.
   */
  show(mode: WrinkleMode): void {
    if (mode === 'paper' || mode === 'composed') checkNotInstanced(this.#mesh, mode)
    if (mode === 'paper') {
      const smooth = this.#flat ? null : (this.composed?.base ?? this.#material.normalMap)
      this.#inputs.paper ??= {
        ...packPaperArray(this.#inputs.textures.layers, this.#material, smooth),
        table: new ActivationTable(),
      }
    }
    this.#unpatch()
    this.#unpatch = this.#patch(mode)
    this.#material.needsUpdate = true
    this.mode = mode
  }

  /** Copies the material without its wrinkles. */
  clone(): Material {
    this.#unpatch()
    const { normalMap } = this.#material
    if (this.#flat) this.#material.normalMap = null
    // Not the material's own: the loader replaces that, so that copies wrinkle too.
    const copy = Object.getPrototypeOf(this.#material).clone.call(this.#material)
    this.#material.normalMap = normalMap
    this.#unpatch = this.#patch(this.mode)
    return copy
  }

  /**
   * Creates a material that shows influence as gray.
   *
   * @param table fixed activations; null for the current ones.
   */
  influenceMaterial(table: ActivationTable | null): Material {
    return this.#renderer.influenceMaterial(this.#material, this.#inputs, table, instancesOf(this.#mesh))
  }

  /** Restores the material. */
  dispose(): void {
    this.show('off')
    if (this.#flat) {
      this.#material.normalMap = null
      this.#flat.dispose()
    }
    patchedMaterials.delete(this.#material)
    // Renderers cache uniforms with the material; wrinkles added later need their own.
    this.#material.dispose()
  }

  #patch(mode: WrinkleMode): () => void {
    if (mode === 'off') return () => {}
    if (mode === 'composed') return this.#compose()
    return this.#renderer.patch(this.#material, this.#inputs, mode, instancesOf(this.#mesh))
  }

  /** Replaces the material's own normal map by the composed one. */
  #compose(): () => void {
    const { composeMaterial, quads } = this.#renderer
    const base = this.#material.normalMap!
    const normals = this.#inputs.textures.normals.texture
    const composed = new ComposedMap(base, normals, composeMaterial(base, this.#inputs), quads.hasContents)
    this.composed = composed
    this.#material.normalMap = composed.target.texture
    return () => {
      this.#material.normalMap = composed.base
      this.composed = null
      composed.dispose()
    }
  }
}

function problemOf(material: WrinkleMaterial): { what: string; remedy: string } | null {
  if (Array.isArray(material)) {
    return { what: 'mesh with several materials', remedy: 'split the mesh, one material each' }
  }
  if (!('normalMap' in material)) {
    return {
      what: `material ${(material as Material)?.type} does not support normal maps`,
      remedy: 'use a lit material such as MeshStandardMaterial',
    }
  }
  if (material.normalMap && material.normalMapType === ObjectSpaceNormalMap) {
    return { what: 'object-space normal map', remedy: 'bake it to tangent space' }
  }
  if (patchedMaterials.has(material)) {
    return {
      what: 'the material already shows wrinkles',
      remedy: 'give the mesh its own: mesh.material = mesh.material.clone(), or dispose the other wrinkles',
    }
  }
  return null
}
