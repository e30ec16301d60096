import type { AbstractMesh } from '@babylonjs/core/Meshes/abstractMesh.js'
import { FurrowError } from '../core/error.ts'
import type { SkinMaterial } from './check-mesh.ts'
import type { ShaderKind } from './shaders/injections.ts'
import type { SharedSet } from './shared-set.ts'
import { flatNormalTexture } from './textures.ts'
import { type DrawnFace, WrinklePlugin } from './wrinkle-plugin.ts'

/** State of a patched material: the number of faces that use it, and a function that removes the wrinkles from it. */
interface Patch {
  users: number
  remove(): void
}

const patches = new WeakMap<SkinMaterial, Patch>()

/**
 * Patches a material to draw the wrinkles of a set on one face. If the material is already patched, only registers the face.
 *
 * @param shared the wrinkle set.
 * @param faceOf returns the face of a mesh that is being drawn, or undefined if the mesh has no wrinkles.
 * @returns a function that unregisters the face. When the last face is unregistered, the material is restored.
 * @throws FurrowError if the material already draws another set.
 */
export function patchMaterial(
  material: SkinMaterial,
  kind: ShaderKind,
  shared: SharedSet,
  faceOf: (mesh: AbstractMesh) => DrawnFace | undefined,
): () => void {
  const known = material.pluginManager?.getPlugin<WrinklePlugin>(WrinklePlugin.NAME)
  const plugin = known ?? new WrinklePlugin(material, kind, faceOf)
  if (plugin.shared && plugin.shared !== shared) {
    throw new FurrowError({
      who: 'Wrinkles',
      problem: `material "${material.name}" already shows another wrinkle set`,
      limit: 'one set per material',
      remedy: 'clone the material, or pass its current wrinkles to `new Wrinkles`',
    })
  }
  const patch = patches.get(material) ?? apply(material, plugin, shared)
  patches.set(material, patch)
  patch.users++
  return () => {
    if (--patch.users > 0) return
    patches.delete(material)
    patch.remove()
  }
}

function apply(material: SkinMaterial, plugin: WrinklePlugin, shared: SharedSet): Patch {
  plugin.shared = shared
  const restoreNormals = material.bumpTexture ? () => {} : addFlatNormals(material)
  const remove = () => {
    plugin.shared = null
    restoreNormals()
  }
  return { users: 0, remove }
}

/** Adds a flat normal map to a material. Without a normal map, shaders skip the code that mixes normals. Returns an undo function. */
function addFlatNormals(material: SkinMaterial): () => void {
  const scene = material.getScene()
  const flat = flatNormalTexture(scene)
  const { invertNormalMapX, invertNormalMapY } = material
  material.bumpTexture = flat
  // The glTF loader of Babylon.js sets the same values.
  material.invertNormalMapX = !scene.useRightHandedSystem
  material.invertNormalMapY = scene.useRightHandedSystem
  return () => {
    if (material.bumpTexture === flat) material.bumpTexture = null
    Object.assign(material, { invertNormalMapX, invertNormalMapY })
    flat.dispose()
  }
}
