import type { Material, RenderTarget } from 'three'
import type { AnyRenderer } from '../renderer.ts'
import type { AreaArray } from './area-array.ts'

/** Operations on the cells of the influence atlas, in draw order: clear cells, add areas, take the maximum with areas. */
export const QUAD_RULES = ['clear', 'sum', 'max'] as const
export type QuadRule = (typeof QUAD_RULES)[number]

/** Renderer-specific functions of the influence atlas. */
export interface QuadMaterials {
  /**
   * Creates a material for one operation: writes 0, adds `weight * activation`, or takes the maximum with `weight * activation`. See `Quads`
   * for the vertex attributes.
   */
  create(rule: QuadRule, areas: AreaArray | null): Material
  /** Whether a target still holds its texels; false after the GPU context was lost. */
  hasContents(renderer: AnyRenderer, target: RenderTarget): boolean
}
