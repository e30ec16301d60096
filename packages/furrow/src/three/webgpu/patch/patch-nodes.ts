import type { MeshStandardNodeMaterial, Node } from 'three/webgpu'
import type { ShownMode } from '../../material/patch.ts'
import type { WrinkleMaterial } from '../../material/wrinkle-material.ts'
import { unwatch, watched } from './build-error.ts'

const PATCHED = [
  'normalNode',
  'colorNode',
  'roughnessNode',
  'aoNode',
  'setupLighting',
  'setupLightingModel',
  'customProgramCacheKey',
] as const

/**
 * A material that may have the properties in `PATCHED`. They also work on materials that are not node materials, because the renderer draws
 * these with a node material to which it copies all properties.
 */
export type Patched = WrinkleMaterial &
  Partial<Pick<MeshStandardNodeMaterial, Exclude<(typeof PATCHED)[number], 'customProgramCacheKey'>>>

/** Properties that a patch sets. Every mode sets `normalNode`. */
export type Added = Partial<Patched> & { normalNode: Node<'vec3'> }

let patchCount = 0

/** Sets nodes of a material to show wrinkles. */
export function patchNodes(material: Patched, added: Added): Pick<ShownMode, 'undo'> {
  const original = Object.fromEntries(
    PATCHED.filter((key) => Object.hasOwn(material, key)).map((key) => [key, material[key]]),
  )
  const { customProgramCacheKey } = material
  // The renderer shares a program between non-node materials with equal properties, and does not compare their nodes. The nodes of different
  // patches read different textures, so each patch needs a separate program.
  const variant = `furrow ${patchCount++}`
  Object.assign(material, added, {
    normalNode: watched(material, added.normalNode),
    customProgramCacheKey: () => `${customProgramCacheKey.call(material)} ${variant}`,
  })
  return {
    undo() {
      unwatch(material)
      for (const key of PATCHED) if (!(key in original)) Reflect.deleteProperty(material, key)
      Object.assign(material, original)
    },
  }
}
