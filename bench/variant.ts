/// <reference types="vite/client" />
import type { WrinkleSet } from 'furrow'
import type { Mesh } from 'three'
import type { Case, RendererKind } from './case.ts'

/** A way to show wrinkles. */
export interface Variant {
  /** Whether it can show a case at all. */
  canShow(shown: Case, renderer: RendererKind): boolean
  /** Puts the wrinkles on a face of its own. */
  wear(mesh: Mesh, set: WrinkleSet, renderer: RendererKind): Worn
}

export interface Worn {
  setActivation(area: string, value: number): void
  dispose(): void
}

const modules = import.meta.glob<{ variant: Variant }>('./variants/*.ts', { eager: true })

/** Every variant by its name: that of its file. */
export const VARIANTS: ReadonlyMap<string, Variant> = new Map(
  Object.entries(modules).map(([path, { variant }]) => [path.replace(/^.*\/|\.ts$/g, ''), variant]),
)
