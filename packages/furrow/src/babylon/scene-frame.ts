import type { Scene } from '@babylonjs/core/scene.js'
import { Frame, type FrameEntry, type FrameMember } from '../runtime/frame.ts'

/** The mesh of a member, as far as it decides whether the member takes part. */
export interface SceneMember extends FrameMember<Scene> {
  /** Whether the face may be drawn in this frame. */
  readonly isShown: boolean
  /** Looks for copies of the mesh that the page has made. */
  adopt(): void
}

/** The frames of one scene: runs the phases of all faces that may be drawn, once before anything of the frame is. */
export class SceneFrame extends Frame<Scene> {
  readonly #members = new Map<SceneMember, FrameEntry<Scene>>()
  readonly #scene: Scene

  constructor(scene: Scene) {
    super(() => scene.getFrameId())
    this.#scene = scene
    scene.onBeforeRenderObservable.add(() => this.#begin())
  }

  join(member: SceneMember): void {
    this.#members.set(member, this.add(member))
  }

  leave(member: SceneMember): void {
    const entry = this.#members.get(member)
    if (entry) this.remove(entry)
    this.#members.delete(member)
  }

  /** Runs the phases of one member now; influence is drawn only with a scene. */
  run(member: SceneMember, scene: Scene | null): void {
    this.update(this.#members.get(member)!, scene)
  }

  #begin(): void {
    for (const member of this.#members.keys()) member.adopt()
    for (const [member, entry] of this.#members) if (member.isShown) this.begin(entry, this.#scene)
  }
}

const frames = new WeakMap<Scene, SceneFrame>()

/** The frames of a scene, one object for all its faces. */
export function sceneFrame(scene: Scene): SceneFrame {
  const frame = frames.get(scene) ?? new SceneFrame(scene)
  frames.set(scene, frame)
  return frame
}
