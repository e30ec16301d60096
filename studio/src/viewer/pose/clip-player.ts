import { batch, computed, type ReadonlySignal, type Signal, signal } from '@preact/signals'
import { type AnimationAction, type AnimationClip, AnimationMixer, type Object3D } from 'three'
import type { Viewer } from '../viewer.ts'
import { splitWeights } from './split-weights.ts'

/** Animation that the player lists. */
export interface Clip {
  readonly name: string
  readonly animation: AnimationClip
  /** Part that is played: in and out points, seconds. */
  readonly range: readonly [start: number, end: number]
}

export interface ClipPlayerParts {
  viewer: ReadonlySignal<Pick<Viewer, 'move'> | null>
  /** Called before a clip moves the face, to stop other motion. */
  begin(): void
  /** Called after the pose changed, so that a frame is drawn. */
  onPose(): void
}

/** Plays key frames on the face: animations of the avatar's file, and takes. */
export class ClipPlayer {
  readonly #parts: ClipPlayerParts
  readonly #own = signal<readonly Clip[]>([])
  readonly #takes = signal<readonly Clip[]>([])
  readonly #chosen = signal<AnimationClip | null>(null)
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

  /** Animations of the avatar's file. */
  get own(): ReadonlySignal<readonly Clip[]> {
    return this.#own
  }

  get takes(): ReadonlySignal<readonly Clip[]> {
    return this.#takes
  }

  /** Chosen clip: by default the first of the file or, if it has none, the first take. */
  readonly clip: ReadonlySignal<Clip | null> = computed(() => {
    const clips = [...this.#own.value, ...this.#takes.value]
    return clips.find(({ animation }) => animation === this.#chosen.value) ?? clips[0] ?? null
  })

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

  /** Opens an avatar with the animations of its file. */
  open(root: Object3D, animations: readonly AnimationClip[]): void {
    this.#action = null
    this.#mixer = new AnimationMixer(root)
    batch(() => {
      this.#isShown.value = this.#isPlaying.value = false
      this.#own.value = animations.filter(({ tracks }) => tracks.length > 0).map(clipOf)
      this.#chosen.value = null
      this.#time.value = this.#range[0]
    })
  }

  /** Replaces the takes. If the chosen take is gone, stops it. */
  setTakes(takes: readonly Clip[]): void {
    const before = this.clip.peek()
    const isGone =
      this.#takes.peek().includes(before!) && takes.every((each) => each.animation !== before!.animation)
    if (isGone) this.stop()
    this.#takes.value = takes
    if (isGone || !before) this.#time.value = this.#range[0]
  }

  /** Chooses a clip. Starts it if another clip was playing. */
  choose({ animation }: Clip): void {
    const isPlaying = this.#isPlaying.peek()
    this.stop()
    this.#chosen.value = animation
    this.#time.value = this.#range[0]
    if (isPlaying) this.play()
  }

  /** Plays the clip from its current time. Starts at its in point if the time is outside the in and out points. */
  play(): void {
    if (!this.clip.peek()) return
    const [start, end] = this.#range
    const time = this.#time.peek()
    this.#seek(time < start || time >= end ? start : time)
    this.#isPlaying.value = this.#action !== null
    this.#parts.onPose()
  }

  toggle(): void {
    if (this.#isPlaying.peek()) this.pause()
    else this.play()
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
    this.#time.value = this.#range[0]
    if (!this.#action) return
    this.#action = null
    this.#isShown.value = false
    this.#parts.viewer.peek()?.move(() => this.#mixer?.stopAllAction())
    this.#parts.onPose()
  }

  /** @param delta seconds since the last frame. */
  advance(delta: number): void {
    if (!this.#isPlaying.peek()) return
    const [start, end] = this.#range
    const time = this.#time.peek() + delta * this.speed.peek()
    if (time < end) this.#seek(time)
    else if (this.isLooped.peek()) this.#seek(end > start ? start + ((time - start) % (end - start)) : start)
    else {
      this.pause()
      this.#seek(end)
    }
  }

  get #range(): readonly [number, number] {
    return this.clip.peek()?.range ?? [0, 0]
  }

  #begin(): void {
    const [clip, mixer] = [this.clip.peek(), this.#mixer]
    if (!clip || !mixer || !this.#parts.viewer.peek()) return
    this.#parts.begin()
    this.#action = mixer.clipAction(clip.animation).reset().play()
    this.#isShown.value = true
  }
}

function clipOf(animation: AnimationClip): Clip {
  const split = splitWeights(animation)
  return { name: animation.name, animation: split, range: [0, split.duration] }
}
