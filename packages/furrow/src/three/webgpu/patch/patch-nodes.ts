import type { MeshStandardNodeMaterial, Node } from 'three/webgpu'
import type { ShownMode } from '../../material/patch.ts'
import type { WrinkleMaterial } from '../../material/wrinkle-material.ts'
import { unwatch, watched } from './build-fault.ts'

const PATCHED = [
  'normalNode',
  'colorNode',
  'roughnessNode',
  'aoNode',
  'setupLighting',
  'setupLightingModel',
  'customProgramCacheKey',
] as const

/** What the patch sets; plain materials carry these too, the renderer copies them to the nodes it makes. */
export type Patched = WrinkleMaterial &
  Partial<Pick<MeshStandardNodeMaterial, Exclude<(typeof PATCHED)[number], 'customProgramCacheKey'>>>

/** What it sets in any mode, and more. */
export type Added = Partial<Patched> & { normalNode: Node<'vec3'> }

let patchCount = 0

/** Sets nodes of a material. */
export function patchNodes(material: Patched, added: Added): Pick<ShownMode, 'undo'> {
  const original = Object.fromEntries(
    PATCHED.filter((key) => Object.hasOwn(material, key)).map((key) => [key, material[key]]),
  )
  const { customProgramCacheKey } = material
  // The renderer shares one built program among plain materials with equal properties, and nodes are not
  // among those it compares; these read textures of their own.
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
