import type { AbstractMesh } from '@babylonjs/core/Meshes/abstractMesh.js'
import { FurrowError } from '../core/error.ts'
import type { SkinMaterial } from './check-mesh.ts'
import type { ShaderKind } from './shaders/injections.ts'
import type { SharedSet } from './shared-set.ts'
import { flatNormalTexture } from './textures.ts'
import { type DrawnFace, WrinklePlugin } from './wrinkle-plugin.ts'

/** How many faces a material shows, and what takes the wrinkles off it. */
interface Patch {
  users: number
  remove(): void
}

const patches = new WeakMap<SkinMaterial, Patch>()

/**
 * Lets a material show the wrinkles of a set, for one more face.
 *
 * @param faceOf the face of a mesh that is drawn.
 * @returns what undoes it, with the last face.
 * @throws FurrowError when it shows those of another set.
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
      problem: `material "${material.name}" shows the wrinkles of another set`,
      limit: 'one set for all meshes with a material',
      remedy: 'give the mesh a clone of the material, or the wrinkles of the other mesh',
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

/** Gives a material a normal map, which shaders read only where there is one. */
function addFlatNormals(material: SkinMaterial): () => void {
  const scene = material.getScene()
  const flat = flatNormalTexture(scene)
  const { invertNormalMapX, invertNormalMapY } = material
  material.bumpTexture = flat
  // As the loader sets them for glTF's normal maps.
  material.invertNormalMapX = !scene.useRightHandedSystem
  material.invertNormalMapY = scene.useRightHandedSystem
  return () => {
    if (material.bumpTexture === flat) material.bumpTexture = null
    Object.assign(material, { invertNormalMapX, invertNormalMapY })
    flat.dispose()
  }
}
