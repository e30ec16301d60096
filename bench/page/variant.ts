/// <reference types="vite/client" />
import type { WrinkleSet } from 'furrow'
import type { Mesh } from 'three'
import type { RendererKind } from '../../stage/stage.ts'
import type { Case } from '../case.ts'

/** A technique for wrinkles that the benchmark compares with others. */
export interface Variant {
  canShow(benchCase: Case, renderer: RendererKind): boolean
  /** Name of another variant. The first frames of both variants must look the same. */
  sameAs?: string
  /** Adds wrinkles to a mesh. No other mesh may use its material, because variants change the material. */
  apply(mesh: Mesh, set: WrinkleSet, renderer: RendererKind, benchCase: Case): AppliedVariant
}

export interface AppliedVariant {
  /** Resolves when the variant can be drawn. Default: the variant can be drawn at once. */
  ready?: Promise<void>
  setActivation(area: string, value: number): void
  dispose(): void
}

const modules = import.meta.glob<{ variant: Variant }>('./variants/*.ts', { eager: true })

/** All variants, by file name without extension. */
export const VARIANTS: ReadonlyMap<string, Variant> = new Map(
  Object.entries(modules).map(([path, { variant }]) => [path.replace(/^.*\/|\.ts$/g, ''), variant]),
)
