import type { GLTFParser } from 'three/addons/loaders/GLTFLoader.js'
import { WRINKLE_MAPS } from '../../core/maps/declared.ts'
import { extensionOf } from '../../runtime/file/read-wrinkles.ts'

/**
 * Plugin of `GLTFLoader` that keeps the extension FURROW_wrinkle_maps in the JSON of materials. Other plugins may replace
 * `material.extensions` in `beforeRoot`. For example, three-vrm's `VRMMaterialsV0CompatPlugin` replaces the extensions of MToon and
 * `VRM/Unlit` materials of VRM 0. This plugin restores the extension, so that `readWrinkleMaps` finds it.
 */
export class DeclaredWrinkles {
  readonly name = WRINKLE_MAPS
  readonly #parser: GLTFParser
  readonly #byMaterial = new Map<number, unknown>()

  /** Must be created before any plugin changes the file. */
  constructor(parser: GLTFParser) {
    this.#parser = parser
    for (const material of materialsOfMeshes(parser.json)) {
      const declared = extensionOf(material, parser)
      if (declared !== undefined) this.#byMaterial.set(material, declared)
    }
  }

  /** Indices of the materials with wrinkles. */
  get materials(): Iterable<number> {
    return this.#byMaterial.keys()
  }

  /** Called by the loader after everything else is loaded. */
  async afterRoot(): Promise<void> {
    this.restore()
  }

  restore(): void {
    for (const [material, declared] of this.#byMaterial) {
      if (extensionOf(material, this.#parser) !== undefined) continue
      const json = this.#parser.json.materials[material]
      json.extensions = { ...json.extensions, [WRINKLE_MAPS]: declared }
    }
  }
}

/** Returns the indices of the materials that meshes use. Ignores invalid JSON. */
function materialsOfMeshes({ meshes, materials }: GLTFParser['json']): Set<number> {
  const used: unknown[] = [meshes]
    .flat()
    .flatMap((mesh) => [mesh?.primitives].flat().map((part) => part?.material))
  return new Set(used.filter((material): material is number => Boolean(materials?.[material as number])))
}
