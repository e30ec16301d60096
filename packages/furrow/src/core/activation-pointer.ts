import { WRINKLE_MAPS } from './maps/declared.ts'

/** Target of a glTF animation channel that animates the resting activation of one area. */
export interface ActivationPointer {
  /** Index of the material in the file. */
  material: number
  /** Index of the area in the material's extension. */
  area: number
}

const POINTER = new RegExp(`^/materials/(\\d+)/extensions/${WRINKLE_MAPS}/areas/(\\d+)/activation$`)

/**
 * Parses a JSON pointer of the glTF extension KHR_animation_pointer, such as
 * `/materials/0/extensions/FURROW_wrinkle_maps/areas/2/activation`.
 *
 * @returns undefined if the pointer does not name the activation of an area.
 */
export function parseActivationPointer(pointer: unknown): ActivationPointer | undefined {
  const match = typeof pointer === 'string' ? POINTER.exec(pointer) : null
  return match ? { material: Number(match[1]), area: Number(match[2]) } : undefined
}
