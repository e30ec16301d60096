/// <reference types="vite/client" />
import type { WrinkleSet } from 'furrow'
import type { Mesh } from 'three'
import type { RendererKind } from '../../stage/stage.ts'
import type { Case } from '../case.ts'

/** A technique for wrinkles. */
export interface Variant {
  /** Whether it supports a case. */
  canShow(benchCase: Case, renderer: RendererKind): boolean
  /** Variant with an equal first frame. */
  sameAs?: string
  /** Adds wrinkles to a mesh with an unshared material. */
  apply(mesh: Mesh, set: WrinkleSet, renderer: RendererKind, benchCase: Case): AppliedVariant
}

export interface AppliedVariant {
  /** Resolves when it can be drawn. Default: immediately. */
  ready?: Promise<void>
  setActivation(area: string, value: number): void
  dispose(): void
}

const modules = import.meta.glob<{ variant: Variant }>('./variants/*.ts', { eager: true })

/** All variants by file name. */
export const VARIANTS: ReadonlyMap<string, Variant> = new Map(
  Object.entries(modules).map(([path, { variant }]) => [path.replace(/^.*\/|\.ts$/g, ''), variant]),
)
