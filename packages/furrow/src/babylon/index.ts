/**
 * Wrinkles for Babylon.js, with WebGL 2 or WebGPU.
 *
 * @module furrow/babylon
 */

export type { Clock } from '../runtime/face-group.ts'
export type { NamedInputs } from '../runtime/named-inputs.ts'
export type { FaceCalibration, ShapeCalibration } from '../runtime/tracker/calibration.ts'
export type { RecordingKind } from '../runtime/tracker/calibrator.ts'
export type { FaceScore, FrameScores } from '../runtime/tracker/face-tracker.ts'
export type { OneEuroOptions } from '../runtime/tracker/one-euro.ts'
export { FACE_TRACKER_DEFAULTS, type FaceTrackerOptions } from '../runtime/tracker/options.ts'
export { ExpressionPlayer } from './expression-player.ts'
export { FaceTracker } from './face-tracker.ts'
export { type LoaderOptions, WRINKLES_DEFAULTS, type WrinkleMode, type WrinklesOptions } from './options.ts'
export { registerWrinkleMaps } from './register.ts'
export { addDrivers, setDrivers } from './sources/drivers.ts'
export { Wrinkles } from './wrinkles.ts'
export type { WrinklesBase } from './wrinkles-base.ts'
export { type LoadedFile, wrinklesOf } from './wrinkles-of.ts'
