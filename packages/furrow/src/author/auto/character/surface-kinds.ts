/** How a surface folds. Loaders import this module to check options, so it has no other contents. */
export const SURFACE_KINDS = ['skin', 'cloth', 'hard'] as const
/** `skin` creases at joints and by blendshapes, `cloth` folds at joints, and joints do not fold what is `hard`. */
export type SurfaceKind = (typeof SURFACE_KINDS)[number]
