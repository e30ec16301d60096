/** How a surface folds. Loaders import this module to check options, so it has no other contents. */
export const SURFACE_KINDS = ['skin', 'cloth', 'hard'] as const
export type SurfaceKind = (typeof SURFACE_KINDS)[number]
