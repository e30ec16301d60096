import type { Light, PerspectiveCamera, Scene } from 'three'
import type { Face } from '../../stage/face.ts'
import type { RendererKind } from '../../stage/stage.ts'
import type { TimedRenderer } from './timed-renderer.ts'

/** A scene that variants are timed in. */
export interface Bench {
  renderer: RendererKind
  timedRenderer: TimedRenderer
  face: Face
  scene: Scene
  /** What occlusion darkens: lights alone cast no light that it would. */
  surroundings: Light
  camera: PerspectiveCamera
}
