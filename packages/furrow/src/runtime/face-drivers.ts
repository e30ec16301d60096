import type { Face } from './face.ts'

/** What drives the areas of a mesh's faces, with one method per phase of a frame. Each runs for all of them before the next. */
export interface FaceDrivers<Engine> {
  /** Areas that the face's own motion activates, see `DriverPlan`. */
  readonly movedAreas: ReadonlySet<string>
  /** Phase 1: reads the inputs of all faces. */
  readInputs(faces: readonly Face[], clock: { now(): number }, engine: Engine | null): void
  /** Phase 2: evaluates the drivers of all faces. */
  evaluate(faces: readonly Face[]): void
  /** Phase 3: sets the faces' activations. */
  apply(faces: readonly Face[]): void
}
