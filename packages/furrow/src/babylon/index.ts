/**
 * Wrinkles for Babylon.js, with WebGL 2 or WebGPU.
 *
 * @module furrow/babylon
 */

export type { Clock } from '../runtime/face-group.ts'
export type { FaceScore } from '../runtime/face-scores.ts'
export type { NamedInputs } from '../runtime/named-inputs.ts'
export { ExpressionPlayer } from './expression-player.ts'
export { FaceScores } from './face-scores.ts'
export { type LoaderOptions, WRINKLES_DEFAULTS, type WrinkleMode, type WrinklesOptions } from './options.ts'
export { registerWrinkleMaps } from './register.ts'
export { addDrivers, setDrivers } from './sources/drivers.ts'
export { Wrinkles } from './wrinkles.ts'
export type { WrinklesBase } from './wrinkles-base.ts'
export { type LoadedFile, wrinklesOf } from './wrinkles-of.ts'
