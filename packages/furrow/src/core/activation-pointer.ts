import { WRINKLE_MAPS } from './wrinkle-maps.ts'

/** What an animation of a file moves: the activation at rest of one area, by index. */
export interface ActivationPointer {
  material: number
  area: number
}

const POINTER = new RegExp(`^/materials/(\\d+)/extensions/${WRINKLE_MAPS}/areas/(\\d+)/activation$`)

/** Reads a pointer of KHR_animation_pointer; undefined where it points at something else. */
export function parseActivationPointer(pointer: unknown): ActivationPointer | undefined {
  const match = typeof pointer === 'string' ? POINTER.exec(pointer) : null
  return match ? { material: Number(match[1]), area: Number(match[2]) } : undefined
}
