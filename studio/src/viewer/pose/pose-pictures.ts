import { effect, type ReadonlySignal, signal } from '@preact/signals'
import { runInTurn } from '../../later.ts'
import type { Viewer } from '../viewer.ts'
import { poseOf, writePose } from './pose.ts'

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

/** Small pictures of the face with each of its expressions. Draws them while the page is idle, and again for other expressions. */
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

  /** Data URLs of the pictures. The keys are the names of the expressions. */
  get urls(): ReadonlySignal<ReadonlyMap<string, string>> {
    return this.#urls
  }

  #request(): void {
    const viewer = this.#parts.live()
    if (!viewer) return
    const names = viewer.expressions.map(({ name }) => name)
    const source = [viewer.avatar.root, viewer.avatar.skin, viewer.wrinkles !== null, ...names]
    if (source.length === this.#drawn.length && source.every((each, i) => each === this.#drawn[i])) return
    this.#cancel?.()
    this.#cancel = runInTurn(() => {
      if (viewer !== this.#parts.live()) return
      if (this.#parts.isMoving() || viewer.canvas.width < SIDE) {
        setTimeout(() => this.#request(), RETRY)
        return
      }
      this.#drawn = source
      this.#urls.value = draw(viewer, names.slice(0, MAX_PICTURES))
    })
  }
}

/** Draws all pictures in one task, and then the previous frame again, so that the stage does not flicker. */
function draw(viewer: Viewer, names: readonly string[]): Map<string, string> {
  const { stage, canvas, split, look } = viewer
  const { camera } = stage
  const before = poseOf(viewer)
  const [position, rotation] = [camera.position.clone(), camera.quaternion.clone()]
  const { fov, near, far } = camera
  const { clientWidth, clientHeight, width } = canvas
  try {
    viewer.split = 0
    if (look.name !== 'shaded') viewer.look = { name: 'shaded' }
    stage.resize(SIDE, SIDE)
    stage.view(VIEW)
    return new Map(
      names.map((name) => {
        viewer.play(name, 0)
        viewer.draw()
        return [name, canvas.toDataURL('image/jpeg', 0.85)]
      }),
    )
  } finally {
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
