import type { Scene } from '@babylonjs/core/scene.js'
import { Frame, type FrameEntry, type FrameMember } from '../runtime/frame.ts'

/** A face of a Babylon.js scene. */
export interface SceneMember extends FrameMember<Scene> {
  /** Whether the face may be drawn in this frame. */
  readonly isShown: boolean
  /** Adds wrinkles to all clones and instances that the page has made of the face's meshes. */
  adopt(): void
}

/** Updates all visible faces of a scene once per frame, before the first draw call. `Frame` documents the phases of an update. */
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

  /** Updates one face now. Influence maps are drawn only if a scene is given. */
  run(member: SceneMember, scene: Scene | null): void {
    this.update(this.#members.get(member)!, scene)
  }

  #begin(): void {
    for (const member of this.#members.keys()) member.adopt()
    for (const [member, entry] of this.#members) if (member.isShown) this.begin(entry, this.#scene)
  }
}

const frames = new WeakMap<Scene, SceneFrame>()

/** Returns the `SceneFrame` of a scene. All faces of the scene share it. */
export function sceneFrame(scene: Scene): SceneFrame {
  const frame = frames.get(scene) ?? new SceneFrame(scene)
  frames.set(scene, frame)
  return frame
}
