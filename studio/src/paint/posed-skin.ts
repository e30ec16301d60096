import type { Mesh } from 'three'
import { PaintSkin } from './paint-skin.ts'
import { SkinPicker } from './picker.ts'
import { readSkin } from './read-skin.ts'

/** The skin of a face as all tools use it. */
export interface PosedSkin {
  /** At rest. */
  readonly skin: PaintSkin
  readonly picker: SkinPicker
}

/** By the meshes, which are one array for as long as the avatar is open. */
const lastMade = new WeakMap<readonly Mesh[], PosedSkin & { scale: number }>()

/**
 * The skin of a face in its present pose. It is read once, which takes a third of a second for a scan: later calls refit the same picker.
 *
 * @param scale millimetres per unit of its positions.
 * @throws FurrowError when it cannot be painted.
 */
export function posedSkinOf(meshes: readonly [Mesh, ...Mesh[]], scale: number): PosedSkin {
  const last = lastMade.get(meshes)
  if (last?.scale === scale) {
    last.picker.refit()
    return last
  }
  const read = readSkin(meshes)
  const skin = new PaintSkin(read.skin, scale)
  const made = { skin, picker: new SkinPicker(read, skin), scale }
  lastMade.set(meshes, made)
  return made
}
