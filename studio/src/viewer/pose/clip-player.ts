import { type ReadonlySignal, type Signal, signal } from '@preact/signals'
import { type AnimationAction, type AnimationClip, AnimationMixer, type Object3D } from 'three'
import type { Viewer } from '../viewer.ts'
import { splitWeights } from './split-weights.ts'

export interface ClipPlayerParts {
  viewer: ReadonlySignal<Pick<Viewer, 'move'> | null>
  /** Called before a clip moves the face, to stop other motion. */
  begin(): void
  /** Called after the pose changed, so that a frame is drawn. */
  onPose(): void
}

/** Plays key frames on the face: animations from the avatar's file, and facial captures. */
export class ClipPlayer {
  readonly #parts: ClipPlayerParts
  readonly #clips = signal<readonly AnimationClip[]>([])
  readonly #clip = signal<AnimationClip | null>(null)
  readonly #time = signal(0)
  readonly #isPlaying = signal(false)
  readonly #isShown = signal(false)
  #mixer: AnimationMixer | null = null
  /** Current action, or null while no clip moves the face. */
  #action: AnimationAction | null = null

  readonly isLooped = signal(true)
  readonly speed: Signal<number> = signal(1)

  constructor(parts: ClipPlayerParts) {
    this.#parts = parts
  }

  get clips(): ReadonlySignal<readonly AnimationClip[]> {
    return this.#clips
  }

  get clip(): ReadonlySignal<AnimationClip | null> {
    return this.#clip
  }

  /** Clip time, seconds. */
  get time(): ReadonlySignal<number> {
    return this.#time
  }

  get isPlaying(): ReadonlySignal<boolean> {
    return this.#isPlaying
  }

  /** Whether the clip determines the pose of the face. Also true while the clip is paused. */
  get isShown(): ReadonlySignal<boolean> {
    return this.#isShown
  }

  /** Opens an avatar with the clips of its file. */
  open(root: Object3D, animations: readonly AnimationClip[]): void {
    this.#action = null
    this.#isShown.value = this.#isPlaying.value = false
    this.#mixer = new AnimationMixer(root)
    this.#clips.value = animations.filter(({ tracks }) => tracks.length > 0).map(splitWeights)
    this.#clip.value = this.#clips.value[0] ?? null
    this.#time.value = 0
  }

  /** Adds and chooses a clip. Replaces a clip of the same name. */
  add(clip: AnimationClip): void {
    this.#clips.value = [...this.#clips.value.filter(({ name }) => name !== clip.name), clip]
    this.choose(clip)
  }

  /** Chooses a clip. Starts it if another clip was playing. */
  choose(clip: AnimationClip): void {
    const isPlaying = this.#isPlaying.peek()
    this.stop()
    this.#clip.value = clip
    if (isPlaying) this.play()
  }

  /** Plays the clip from its current time, or from the start if it has ended. */
  play(): void {
    const clip = this.#clip.peek()
    if (!clip) return
    this.#seek(this.#time.peek() >= clip.duration ? 0 : this.#time.peek())
    this.#isPlaying.value = this.#action !== null
    this.#parts.onPose()
  }

  pause(): void {
    this.#isPlaying.value = false
  }

  /** Seeks to a time in seconds and pauses. */
  scrub(time: number): void {
    this.pause()
    this.#seek(time)
  }

  #seek(time: number): void {
    if (!this.#action) this.#begin()
    const [viewer, action] = [this.#parts.viewer.peek(), this.#action]
    if (!viewer || !action) return
    this.#time.value = time
    viewer.move(() => {
      action.time = time
      this.#mixer?.update(0)
    })
    this.#parts.onPose()
  }

  /** Stops the clip and restores the pose that the face had before. */
  stop(): void {
    this.#isPlaying.value = false
    this.#time.value = 0
    if (!this.#action) return
    this.#action = null
    this.#isShown.value = false
    this.#parts.viewer.peek()?.move(() => this.#mixer?.stopAllAction())
    this.#parts.onPose()
  }

  /** @param delta seconds since the last frame. */
  advance(delta: number): void {
    const clip = this.#clip.peek()
    if (!clip || !this.#isPlaying.peek()) return
    const time = this.#time.peek() + delta * this.speed.peek()
    if (time < clip.duration) this.#seek(time)
    else if (this.isLooped.peek()) this.#seek(clip.duration > 0 ? time % clip.duration : 0)
    else {
      this.pause()
      this.#seek(clip.duration)
    }
  }

  #begin(): void {
    const [clip, mixer] = [this.#clip.peek(), this.#mixer]
    if (!clip || !mixer || !this.#parts.viewer.peek()) return
    this.#parts.begin()
    this.#action = mixer.clipAction(clip).reset().play()
    this.#isShown.value = true
  }
}
