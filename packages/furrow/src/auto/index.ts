/**
 * Makes wrinkles from blendshapes automatically, in a web worker.
 *
 * @module furrow/auto
 */

// Only types are exported from `furrow/author`: on pages without a bundler, a value would fetch all of its modules.
export type { AutoRegion } from '../author/auto/anatomy/region-names.ts'
export type { AutoArea, AutoProgress, AutoWrinkles } from '../author/auto/auto.ts'
export type { AutoOptions } from '../author/auto/options.ts'
export type { AutoLayer } from '../author/auto/raster/draw-maps.ts'
export type { Skin, SkinTarget } from '../author/skin/surface.ts'
export { type AutoInWorkerOptions, autoWrinklesInWorker } from './in-worker.ts'
export type { AutoRunOptions } from './run-options.ts'
