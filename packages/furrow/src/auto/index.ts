/**
 * Makes wrinkles from blendshapes and joints automatically, in a web worker.
 *
 * @module furrow/auto
 */

// This module exports only types of `furrow/author`. Exporting a value would make pages without a bundler fetch all modules of `furrow/author`.
export type { AutoRegion } from '../author/auto/anatomy/region-names.ts'
export type { AutoArea, AutoProgress, AutoWrinkles, JointArea } from '../author/auto/auto.ts'
export type { SurfaceKind } from '../author/auto/character/surface-kinds.ts'
export type { ClothKind } from '../author/auto/cloth/cloth-kinds.ts'
export type { AutoOptions } from '../author/auto/options.ts'
export type { AutoLayer } from '../author/auto/raster/draw-maps.ts'
export type { SkinJoint, SkinSkeleton } from '../author/skin/skeleton.ts'
export type { Skin, SkinTarget } from '../author/skin/surface.ts'
export { type AutoInWorkerOptions, autoWrinklesInWorker } from './in-worker.ts'
export type { AutoCharacterOptions, AutoRunOptions } from './run-options.ts'
