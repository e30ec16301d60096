import type { CheckedAccessor } from '../json/checked-json.ts'

/** Bytes per component type (glTF 2.0, 3.6.2.2). */
export const COMPONENT_BYTES = new Map([
  [5120, 1],
  [5121, 1],
  [5122, 2],
  [5123, 2],
  [5125, 4],
  [5126, 4],
])
/** Components per element type (glTF 2.0, 3.6.2.2). */
export const COMPONENTS = new Map([
  ['SCALAR', 1],
  ['VEC2', 2],
  ['VEC3', 3],
  ['VEC4', 4],
  ['MAT2', 4],
  ['MAT3', 9],
  ['MAT4', 16],
])

/** Returns the size of an element in bytes, or NaN if its type is unknown. */
export function elementBytes({
  componentType,
  type,
}: Pick<CheckedAccessor, 'componentType' | 'type'>): number {
  return (COMPONENT_BYTES.get(componentType) ?? Number.NaN) * (COMPONENTS.get(type) ?? Number.NaN)
}
