import type { Material, RenderTarget } from 'three'
import type { AnyRenderer } from '../renderer.ts'
import type { AreaArray } from './area-array.ts'

/** In this order: all cells are cleared before sums are added, and sums are complete before the maximum. */
export const QUAD_RULES = ['clear', 'sum', 'max'] as const
export type QuadRule = (typeof QUAD_RULES)[number]

/** What depends on the renderer: the quads' materials, and whether a target still holds what was drawn. */
export interface QuadMaterials {
  /** A material that writes 0, adds weight x activation, or takes the maximum with it; see `Quads` for the attributes. */
  create(rule: QuadRule, areas: AreaArray | null): Material
  /** False after the renderer's context was lost. */
  hasContents(renderer: AnyRenderer, target: RenderTarget): boolean
}
