/** Exports shared by `furrow/three` and `furrow/webgpu`. */

export type { Bounds } from '../core/bounds.ts'
export type { Clock } from '../runtime/face-group.ts'
export { decodeImage, toGray } from '../runtime/file/decode-image.ts'
export type { NamedInputs } from '../runtime/named-inputs.ts'
export type { FaceCalibration, ShapeCalibration } from '../runtime/tracker/calibration.ts'
export type { RecordingKind } from '../runtime/tracker/calibrator.ts'
export type { FaceScore, FrameScores } from '../runtime/tracker/face-tracker.ts'
export type { OneEuroOptions } from '../runtime/tracker/one-euro.ts'
export { FACE_TRACKER_DEFAULTS, type FaceTrackerOptions } from '../runtime/tracker/options.ts'
export { activationTrack } from './activation-track.ts'
export { type FaceView, frameFace } from './camera/frame-face.ts'
export { ExpressionPlayer } from './ExpressionPlayer.ts'
export { FaceTracker } from './FaceTracker.ts'
export type { ExtendableLoader } from './loader/extend-loader.ts'
export { loadWrinkleSet } from './loader/load-wrinkle-set.ts'
export { type LoadedWrinkles, readWrinkleMaps } from './loader/read-wrinkle-maps.ts'
export {
  type ReliefMode,
  WRINKLES_DEFAULTS,
  type WrinkleLoaderOptions,
  type WrinkleMode,
  type WrinklesOptions,
} from './options.ts'
export { RecomputedNormals } from './RecomputedNormals.ts'
export type { AnyRenderer } from './renderer.ts'
export { addDrivers, type DriversOptions, setDrivers } from './sources/drivers.ts'
export { addMorphNormals, addMuscles } from './sources/muscles.ts'
export type { WrinkleStatistics } from './statistics.ts'
export { addArea, removeArea } from './update/change-areas.ts'
export { type LayerScale, scaleLayer } from './update/scale-layer.ts'
export { updateArea } from './update/update-area.ts'
export { type LayerImages, updateLayer } from './update/update-layer.ts'
export type { WrinklesBase } from './wrinkles-base.ts'
export { type LoadedFile, wrinklesOf, wrinklesReady } from './wrinkles-of.ts'
