import type { Light, PerspectiveCamera, Scene } from 'three'
import type { Face } from '../../stage/face.ts'
import type { RendererKind } from '../../stage/stage.ts'
import type { TimedRenderer } from './timed-renderer.ts'

/** A scene for timing variants. */
export interface Bench {
  renderer: RendererKind
  timedRenderer: TimedRenderer
  face: Face
  scene: Scene
  /** Ambient light, the only light that occlusion darkens. */
  ambient: Light
  camera: PerspectiveCamera
}
