import type { Light, PerspectiveCamera, Scene } from 'three'
import type { Face } from '../../stage/face.ts'
import type { RendererKind } from '../../stage/stage.ts'
import type { TimedRenderer } from './timed-renderer.ts'

/** The scene, camera and renderer with which the page measures frame times. */
export interface Bench {
  renderer: RendererKind
  timedRenderer: TimedRenderer
  face: Face
  scene: Scene
  /** Ambient light. Occlusion maps darken only this light. */
  ambient: Light
  camera: PerspectiveCamera
}
