import { type ReadonlySignal, type Signal, signal, untracked } from '@preact/signals'
import { Box3, Sphere, Vector3 } from 'three'
import type { Messages } from '../messages.ts'
import { reducedMotion } from '../motion.ts'
import type { Hovered } from './hovered.ts'
import { MeshVisibility } from './mesh-visibility.ts'
import type { Orbit } from './orbit.ts'
import { ClipPlayer } from './pose/clip-player.ts'
import type { Dial } from './pose/dials.ts'
import { LivePose } from './pose/live-pose.ts'
import { Performer } from './pose/performer.ts'
import { PosePictures } from './pose/pose-pictures.ts'
import { Staging } from './staging.ts'
import type { Viewer } from './viewer.ts'

/** Duration of a transition between expressions, seconds. */
const EXPRESSION_TIME = 0.35
/** Radius of the sphere that the camera shows around folds, relative to their size. */
const AROUND = 2

export interface ShownFaceParts {
  /** Returns the viewer of the face, or null while another face is being opened. */
  live(): Viewer | null
  orbit(): Orbit | null
  /** Moves the divider to the left of a horizontal position, 0 (left edge of the stage) to 1 (right edge). */
  uncover(x: number): void
  messages: Messages
  /** Requests the next frame. */
  wake(): void
}

/** State and motion of the face on the stage. The controls show and change them. */
export class ShownFace {
  /** Null before the first face is open. */
  readonly viewer = signal<Viewer | null>(null)
  readonly hovered: Signal<Hovered | null> = signal(null)
  readonly staging: Staging
  readonly meshes: MeshVisibility
  readonly pictures: PosePictures
  readonly player: ClipPlayer
  readonly live: LivePose
  /** Whether the user edits the face. It then keeps its pose. */
  readonly isEdited = signal(false)
  readonly #parts: ShownFaceParts
  readonly #performer: Performer
  readonly #frame = signal(0)
  readonly #revision = signal(0)
  readonly #expression = signal<string | null>(null)
  readonly #bodyPose = signal<string | null>(null)

  constructor(parts: ShownFaceParts) {
    this.#parts = parts
    const { viewer } = this
    this.staging = new Staging({ viewer, orbit: parts.orbit, wake: parts.wake })
    this.meshes = new MeshVisibility(viewer, parts.wake)
    const onPose = () => {
      this.#frame.value++
      parts.wake()
    }
    this.#performer = new Performer({ viewer, isSideLit: this.staging.isSideLit, onPose })
    this.pictures = new PosePictures({
      viewer,
      live: parts.live,
      revision: this.#revision,
      isMoving: () => this.isMoving || this.#performer.isPerforming || this.live.isOn.peek(),
    })
    const begin = () => {
      this.#finishMotion()
      this.#expression.value = this.#bodyPose.value = null
    }
    this.player = new ClipPlayer({ viewer, begin, onPose })
    this.live = new LivePose({
      viewer,
      begin: () => {
        this.player.stop()
        begin()
      },
      isHeld: () => this.player.isShown.peek() || this.isEdited.peek(),
      onPose,
    })
  }

  /** Counter that increases when a weight or an activation may have changed. */
  get frame(): ReadonlySignal<number> {
    return this.#frame
  }

  /** Counter that increases when the viewer's areas, mode or look change. */
  get revision(): ReadonlySignal<number> {
    return this.#revision
  }

  /** Expression that the face has or moves to. Null after a slider has changed the face. */
  get expression(): ReadonlySignal<string | null> {
    return this.#expression
  }

  /** Pose of joints that the avatar has or moves to: the name of a pose, or `REST_POSE`. Null after joints were turned otherwise. */
  get bodyPose(): ReadonlySignal<string | null> {
    return this.#bodyPose
  }

  get isMoving(): boolean {
    return (this.#live?.isMoving || this.#performer.isMoving || this.player.isPlaying.peek()) ?? false
  }

  show(viewer: Viewer): void {
    const { root, animations } = viewer.avatar
    const isOther = root !== this.viewer.peek()?.avatar.root
    this.viewer.value = viewer
    if (!isOther) return
    this.#expression.value = this.#bodyPose.value = null
    this.live.stop()
    this.player.open(root, animations)
  }

  /** @param delta seconds since the last frame. */
  advance(delta: number): void {
    const viewer = this.#live
    const wasMoving = viewer?.isMoving
    viewer?.advance(delta)
    this.#performer.advance(delta)
    this.player.advance(delta)
    if (wasMoving) this.#frame.value++
  }

  /** Makes controls read all values again. */
  refresh(): void {
    this.#revision.value++
    this.#frame.value++
  }

  /** Changes the viewer, shows errors and updates the controls. */
  change(task: (viewer: Viewer) => void): void {
    const viewer = this.#live
    if (!viewer) return
    void this.#parts.messages
      .attempt(() => task(viewer))
      .then(() => {
        this.refresh()
        this.#parts.wake()
      })
  }

  play(name: string): void {
    this.change((viewer) => {
      this.#performer.settle()
      this.#stopMotion()
      viewer.play(name, reducedMotion.matches ? 0 : EXPRESSION_TIME)
      this.#expression.value = name
      this.#frame.value++
    })
  }

  /** Starts a transition to a pose of joints: the name of a pose, or `REST_POSE`. */
  playPose(name: string): void {
    this.change((viewer) => {
      this.#performer.settle()
      this.#stopMotion()
      viewer.playPose(name, reducedMotion.matches ? 0 : EXPRESSION_TIME)
      this.#bodyPose.value = name
      const place = viewer.skeleton.poses.find((pose) => pose.name === name)?.place()
      const x = place && this.#parts.orbit()?.show(new Vector3(...place.middle), AROUND * place.size)
      if (x !== undefined) this.#parts.uncover(x)
      this.#frame.value++
    })
  }

  /** Looks at the mesh whose wrinkles are shown: at its face, or at all of it if it has no blendshapes. */
  frameSkin(): void {
    const { skins, skin } = this.#live?.avatar ?? {}
    const orbit = this.#parts.orbit()
    if (!skins || skin === undefined || !orbit) return
    const { blendshapes, meshes } = skins[skin]
    if (blendshapes > 0 || skins.length === 1) orbit.goTo('front')
    else {
      const box = meshes.reduce((all, mesh) => all.expandByObject(mesh), new Box3())
      const { center, radius } = box.getBoundingSphere(new Sphere())
      orbit.lookAt(center, radius / 2)
    }
    this.#parts.wake()
  }

  /** Sets a slider. Sliders of blendshapes and of poses stop a clip, and the live pose. */
  input(dial: Dial, value: number): void {
    const { targets, poses } = this.#live ?? {}
    if (targets?.includes(dial) || poses?.includes(dial)) this.set(() => dial.write(value))
    else this.#set(() => dial.write(value))
  }

  /** Changes the pose, and stops the clip and the live pose. */
  set(write: () => void): void {
    this.#set(() => {
      this.#stopMotion()
      write()
    })
  }

  /** Finishes previews and transitions, and then changes sliders. */
  #set(write: () => void): void {
    this.change(() => {
      this.#finishMotion()
      write()
      this.#expression.value = this.#bodyPose.value = null
      this.#frame.value++
    })
  }

  reset(dials: readonly Dial[]): void {
    this.set(() => {
      for (const dial of dials) dial.write(0)
    })
  }

  /** Ends the preview of an area or blendshape. Then returns the weights of all blendshapes. The keys are their names. */
  pose(): Map<string, number> {
    this.settle()
    return new Map(this.#live?.targets.map((dial) => [dial.name, dial.read()]))
  }

  /** Previews the area or recognised blendshape of a control. Null, the slider of a blendshape or a playing clip ends the preview. */
  perform(hovered: Hovered | null): void {
    const isMoved = this.player.isPlaying.peek() || (this.live.isOn.peek() && !this.player.isShown.peek())
    const shown = hovered?.kind === 'target' || isMoved ? null : hovered
    untracked(() => this.#performer.request(shown))
  }

  /** Ends a preview and restores the pose that the face had before. */
  settle(): void {
    this.#performer.settle()
  }

  /**
   * Highlights the areas of the control under the pointer or with the focus. Without such a control, highlights the painted area. Highlights
   * nothing if a preview shows the wrinkles instead.
   */
  highlight(painted: string | null): void {
    const [viewer, hovered] = [this.viewer.value, this.hovered.value]
    if (!viewer) return
    if (!hovered) viewer.highlight(painted === null ? [] : [painted])
    else if (hovered.kind === 'shape') viewer.highlight([])
    else if (hovered.kind === 'target') viewer.highlight(viewer.driven.drivenBy(hovered.name))
    // Do not highlight: the preview shows the wrinkles of the area.
    else if (!hovered.isOnFace && painted === null && viewer.performanceOf(hovered.name)) viewer.highlight([])
    else viewer.highlight([hovered.name])
    this.#parts.wake()
  }

  #stopMotion(): void {
    this.player.stop()
    this.live.stop()
  }

  /** Finishes previews and transitions. A playing clip continues. */
  #finishMotion(): void {
    this.settle()
    this.#live?.advance(Number.POSITIVE_INFINITY)
  }

  get #live(): Viewer | null {
    return this.#parts.live()
  }
}
