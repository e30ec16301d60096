/**
 * `furrow/internal`: names that the rest of the workspace uses beyond the public entries, of rooms without an engine. It is never published: it
 * lies outside `src`, no `exports` of the package name it, and only `scripts/lib/sources.mjs` and `tsconfig.base.json` resolve it.
 */

export { canvasAgain, canvasArrays, type SkinCanvasArrays } from '../src/author/skin/canvas.ts'
export { type UvGrid, UvLocator } from '../src/author/skin/uv-locator.ts'
export { positionAt } from '../src/author/skin/walk.ts'
export { knotsOf, traceStroke, uvOf } from '../src/author/strokes/edit/traced-stroke.ts'
export { BANK_WIDTHS } from '../src/author/strokes/lay-out.ts'
export { buffersOf } from '../src/auto/buffers.ts'
export { skinOf } from '../src/auto/character.ts'
export { CHANNEL, channelOf } from '../src/core/channels.ts'
export { didYouMean, nearestName } from '../src/core/nearest-name.ts'
export { interpolateTexels } from '../src/core/reference.ts'
export { inputName } from '../src/drivers/activation.ts'
export { targetFinder } from '../src/drivers/morph/target-names.ts'
export { splineKnots } from '../src/math/spline.ts'
export { principalStretches, restInverse } from '../src/math/stretch.ts'
export { dot } from '../src/math/vector.ts'
export { readImage } from '../src/runtime/file/read-image.ts'
export type { FileWrinkles } from '../src/runtime/file/read-wrinkles.ts'
