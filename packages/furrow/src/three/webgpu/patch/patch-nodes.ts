import type { MeshStandardNodeMaterial, Node } from 'three/webgpu'
import type { Edit, Patch } from '../../material/patch.ts'
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
export function patchNodes(material: Patched, added: Added): Patch {
  const original = Object.fromEntries(
    PATCHED.filter((key) => Object.hasOwn(material, key)).map((key) => [key, material[key]]),
  )
  const { customProgramCacheKey } = material
  const known = new WeakMap<Edit, object>()
  const patchedBy = (edit: Added) => {
    // The renderer shares one built program among plain materials with equal properties, and nodes are not
    // among those it compares; these read textures of their own.
    const variant = `furrow ${patchCount++}`
    return {
      ...original,
      ...edit,
      normalNode: watched(material, edit.normalNode),
      customProgramCacheKey: () => `${customProgramCacheKey.call(material)} ${variant}`,
    }
  }
  // In place: the order of a material's properties is part of what three.js knows a program by.
  const setEdit = (edit: Edit | null) => {
    if (edit && !known.has(edit)) known.set(edit, patchedBy(edit as Added))
    const patched = (edit && known.get(edit)) ?? original
    Object.assign(material, patched)
    for (const key of PATCHED) if (!(key in patched)) Reflect.deleteProperty(material, key)
  }
  setEdit(added)
  return {
    edit: added,
    setEdit,
    undo() {
      unwatch(material)
      setEdit(null)
    },
  }
}
