import { effect, type ReadonlySignal, signal } from '@preact/signals'
import { runInTurn } from '../../later.ts'
import type { Viewer } from '../viewer.ts'
import type { BodyPose } from './body-poses.ts'
import { poseOf, writePose } from './pose.ts'
import { REST_POSE } from './skeleton-pose.ts'

/** Width and height of a picture, pixels. */
const SIDE = 112
/** Camera of the pictures: near and slightly from the side, so that wrinkles show. */
const VIEW = { yaw: 14, pitch: 2, zoom: 1.7 }
/** Maximum number of pictures. Avatars can have hundreds of expressions. */
const MAX_PICTURES = 40
/** Time until the next attempt if the face moves, milliseconds. */
const RETRY = 400

export interface PosePicturesParts {
  viewer: ReadonlySignal<Viewer | null>
  /** Returns the viewer of the face, or null while another face is being opened. */
  live(): Viewer | null
  /** Counter that increases when expressions may have changed. */
  revision: ReadonlySignal<number>
  /** Whether the face moves, or shows a preview. */
  isMoving(): boolean
}

/**
 * Small pictures of the face with each of its expressions, and of each pose of its joints. Draws them while the page is idle, and again when
 * there are other expressions or poses.
 */
export class PosePictures {
  readonly #parts: PosePicturesParts
  readonly #urls = signal<ReadonlyMap<string, string>>(new Map())
  /** Avatar, expressions and wrinkles of the pictures. */
  #drawn: readonly unknown[] = []
  #cancel: (() => void) | null = null

  constructor(parts: PosePicturesParts) {
    this.#parts = parts
    effect(() => {
      parts.viewer.value
      parts.revision.value
      this.#request()
    })
  }

  /** Data URLs of the pictures. The keys are the names of the expressions and poses. */
  get urls(): ReadonlySignal<ReadonlyMap<string, string>> {
    return this.#urls
  }

  #request(): void {
    const viewer = this.#parts.live()
    if (!viewer) return
    const names = viewer.targets.length > 0 ? viewer.expressions.map(({ name }) => name) : []
    const { poses } = viewer.skeleton
    const shown = [...names, ...poses.map(({ name }) => name)]
    const source = [viewer.avatar.root, viewer.avatar.skin, viewer.wrinkles !== null, ...shown]
    if (source.length === this.#drawn.length && source.every((each, i) => each === this.#drawn[i])) return
    this.#cancel?.()
    this.#cancel = runInTurn(() => {
      if (viewer !== this.#parts.live()) return
      if (this.#parts.isMoving() || viewer.canvas.width < SIDE) {
        setTimeout(() => this.#request(), RETRY)
        return
      }
      this.#drawn = source
      this.#urls.value = draw(viewer, names.slice(0, MAX_PICTURES), poses.slice(0, MAX_PICTURES))
    })
  }
}

/** Draws all pictures in one task, and then the previous frame again, so that the stage does not flicker. */
function draw(viewer: Viewer, names: readonly string[], poses: readonly BodyPose[]): Map<string, string> {
  const { stage, canvas, split, look } = viewer
  const { camera } = stage
  const before = poseOf(viewer)
  const { amounts } = viewer.skeleton
  const [position, rotation] = [camera.position.clone(), camera.quaternion.clone()]
  const { fov, near, far } = camera
  const { clientWidth, clientHeight, width } = canvas
  try {
    viewer.split = 0
    if (look.name !== 'shaded') viewer.look = { name: 'shaded' }
    stage.resize(SIDE, SIDE)
    viewer.playPose(REST_POSE, 0)
    stage.view(VIEW)
    const shoot = () => {
      viewer.draw()
      return canvas.toDataURL('image/jpeg', 0.85)
    }
    const urls = new Map<string, string>()
    for (const name of names) {
      viewer.play(name, 0)
      urls.set(name, shoot())
    }
    if (poses.length === 0) return urls
    const atRest = viewer.skeleton.read()
    writePose(viewer, { ...before, joints: atRest })
    urls.set(REST_POSE, shoot())
    for (const pose of poses) {
      viewer.playPose(pose.name, 0)
      stage.view(pose.view())
      urls.set(pose.name, shoot())
    }
    return urls
  } finally {
    viewer.skeleton.amounts = amounts
    writePose(viewer, before)
    Object.assign(camera, { fov, near, far })
    camera.position.copy(position)
    camera.quaternion.copy(rotation)
    stage.resize(clientWidth, clientHeight, width / clientWidth)
    viewer.split = split
    if (look.name !== 'shaded') viewer.look = look
    viewer.draw()
  }
}
