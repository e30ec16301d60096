/// <reference types="vite/client" />
import type { WrinkleSet } from 'furrow'
import type { Mesh } from 'three'
import type { RendererKind } from '../../stage/stage.ts'
import type { Case } from '../case.ts'

/** A technique to show wrinkles. */
export interface Variant {
  /** Whether it can show a case. */
  canShow(benchCase: Case, renderer: RendererKind): boolean
  /** Name of a variant whose first frame it must draw too. */
  sameAs?: string
  /** Adds the wrinkles to a mesh with a material of its own. */
  apply(mesh: Mesh, set: WrinkleSet, renderer: RendererKind, benchCase: Case): AppliedVariant
}

export interface AppliedVariant {
  /** Fulfilled when it can be drawn; at once by default. */
  ready?: Promise<void>
  setActivation(area: string, value: number): void
  dispose(): void
}

const modules = import.meta.glob<{ variant: Variant }>('./variants/*.ts', { eager: true })

/** Every variant, by the name of its file. */
export const VARIANTS: ReadonlyMap<string, Variant> = new Map(
  Object.entries(modules).map(([path, { variant }]) => [path.replace(/^.*\/|\.ts$/g, ''), variant]),
)
