import type { Area } from '../../core/types.ts'
import { checkWrinkles } from '../../runtime/check-wrinkles.ts'
import { meshOf, type WrinklesBase } from '../wrinkles-base.ts'

/**
 * Adds an area of influence, i.e. a group of wrinkles with its own activation. Does not recompile shaders, except in the mode `paper`.
 *
 * @param wrinkles wrinkles of the face.
 * @param area area as in a wrinkle set; `activation` is its resting activation.
 * @throws FurrowError if the name is taken, the image malformed, the layer unknown, or the wrinkles were disposed of; nothing then
 *   changes.
 */
export function addArea(wrinkles: WrinklesBase, area: Area): void {
  checkWrinkles(wrinkles, 'addArea')
  const mesh = meshOf(wrinkles)
  mesh.checkInUse('addArea')
  mesh.replaceAreas([...mesh.areas, area], 'addArea')
  for (let i = 0; i < wrinkles.faceCount; i++) {
    wrinkles.setRestingActivation(area.name, area.activation ?? 0, i)
  }
}

/**
 * Removes an area of influence from wrinkles. Does not recompile shaders, except in the mode `paper`.
 *
 * @param wrinkles wrinkles of the face.
 * @param name name of the area.
 * @throws FurrowError if the area is unknown or the only area, or the wrinkles were disposed of; nothing then changes.
 */
export function removeArea(wrinkles: WrinklesBase, name: string): void {
  checkWrinkles(wrinkles, 'removeArea')
  const mesh = meshOf(wrinkles)
  mesh.checkInUse('removeArea')
  mesh.getActivation(name)
  mesh.replaceAreas(
    mesh.areas.filter((area) => area.name !== name),
    'removeArea',
  )
}
