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

/** Material with the patched properties. Non-node materials can carry them too: the renderer copies them to its node material. */
export type Patched = WrinkleMaterial &
  Partial<Pick<MeshStandardNodeMaterial, Exclude<(typeof PATCHED)[number], 'customProgramCacheKey'>>>

/** Properties set by a patch; every mode sets `normalNode`. */
export type Added = Partial<Patched> & { normalNode: Node<'vec3'> }

let patchCount = 0

/** Patches the nodes of a material. */
export function patchNodes(material: Patched, added: Added): Pick<ShownMode, 'undo'> {
  const original = Object.fromEntries(
    PATCHED.filter((key) => Object.hasOwn(material, key)).map((key) => [key, material[key]]),
  )
  const { customProgramCacheKey } = material
  // The renderer shares programs among non-node materials with equal properties, but does not compare nodes. These nodes read their own
  // textures, so each patch needs its own program.
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
