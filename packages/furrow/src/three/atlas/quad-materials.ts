import type { Material, RenderTarget } from 'three'
import type { AnyRenderer } from '../renderer.ts'
import type { AreaArray } from './area-array.ts'

/** Draw order: cells are cleared, then sums are added, then the maximum is taken. */
export const QUAD_RULES = ['clear', 'sum', 'max'] as const
export type QuadRule = (typeof QUAD_RULES)[number]

/** Renderer-specific parts of the atlas. */
export interface QuadMaterials {
  /** Creates a material that writes 0, adds weight x activation, or takes the maximum with it. `Quads` documents the attributes. */
  create(rule: QuadRule, areas: AreaArray | null): Material
  /** Whether a target still holds its contents; false after a lost context. */
  hasContents(renderer: AnyRenderer, target: RenderTarget): boolean
}
