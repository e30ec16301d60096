import { isWebGL } from '../../../stage/light.ts'
import type { RendererKind } from '../../../stage/stage.ts'
import { NOTE, PROGRESS } from '../labels/messages.ts'
import { type Loading, nextPaint } from '../loading.ts'
import type { Loop } from '../loop.ts'
import type { Messages } from '../messages.ts'
import { reducedMotion } from '../motion.ts'
import { disposeAvatar, type OpenedAvatar } from '../open/avatar.ts'
import type { Page } from '../page.ts'
import { deviceOf, unavailableReason } from './adapter.ts'
import { type CanvasStage, closeCanvas, openCanvas } from './canvas-stage.ts'
import { Orbit } from './orbit.ts'
import { snapshot } from './snapshot.ts'
import { Viewer } from './viewer.ts'

/** If the WebGPU device is lost twice within this time, in milliseconds, the host opens WebGL instead. */
const LOSS_WINDOW = 15_000

export interface HostParts {
  page: Page
  messages: Messages
  loading: Loading
  /** Render loop, running while there is a viewer. */
  loop: Loop
  /** Called when a viewer is ready, before its first frame. */
  onOpen(viewer: Viewer): void
  /** Called after each attempt to open a viewer. */
  onSettled(): void
}

/** Function that loads an avatar. Receives the current avatar, if there is one. */
export type LoadAvatar = (shown: OpenedAvatar | undefined) => Promise<OpenedAvatar>

/** Opens a viewer. Opens another viewer when the renderer or the avatar changes, or when the graphics device is lost. */
export class ViewerHost {
  readonly #parts: HostParts
  #canvas: CanvasStage | null = null
  #viewer: Viewer | null = null
  #orbit: Orbit | null = null
  /** Promise of the last call of `open`. The next call waits for it, so that the old renderer releases its graphics device first. */
  #opening: Promise<unknown> = Promise.resolve()
  #lastLoss = Number.NEGATIVE_INFINITY
  /** Aborting it removes the event listeners of the current viewer. */
  #watching = new AbortController()

  constructor(parts: HostParts) {
    this.#parts = parts
    new ResizeObserver(() => this.#resize()).observe(parts.page.viewport)
  }

  get viewer(): Viewer | null {
    return this.#viewer
  }

  get orbit(): Orbit | null {
    return this.#orbit
  }

  /** Opens a renderer, optionally with another avatar, and keeps the user's settings. Shows errors. */
  open(kind: RendererKind, load?: LoadAvatar): Promise<unknown> {
    const { messages, loading, onSettled } = this.#parts
    this.#opening = this.#opening.then(() =>
      messages.attempt(async () => {
        try {
          await this.#open(kind, load)
        } finally {
          loading.done()
          onSettled()
        }
      }),
    )
    return this.#opening
  }

  async #open(kind: RendererKind, load?: LoadAvatar): Promise<void> {
    const { page, messages, loading, loop, onOpen } = this.#parts
    const reason = await unavailableReason(kind)
    if (reason && this.#viewer?.kind === 'webgl') throw new Error(reason)
    if (reason) messages.error(reason)
    const last = this.#viewer?.avatar
    const avatar = load ? await load(last) : last
    if (!avatar) return
    loading.show(PROGRESS[reason ? 'webgl' : kind])
    await nextPaint()
    const restore = this.#close()
    const chosen = reason ? 'webgl' : kind
    // Starting a renderer is slower than loading most avatars, so another avatar reuses the stage.
    const canvas = (load && this.#canvas?.kind === chosen && this.#canvas) || (await this.#openCanvas(chosen))
    const viewer = this.#makeViewer(canvas, avatar, last)
    if (viewer.error) messages.error(viewer.error)
    const unused = viewer.avatar === last ? avatar : last
    if (unused && unused.root !== viewer.avatar.root) disposeAvatar(unused)
    this.#viewer = viewer
    this.#orbit = new Orbit(viewer.stage, page.viewport, reducedMotion.matches, () => loop.wake())
    this.#resize()
    if (!restore) this.#orbit.goTo('front', true)
    for (const step of restore?.(viewer, this.#orbit) ?? []) await messages.attempt(step)
    onOpen(viewer)
    this.#watch(viewer)
    loop.start()
  }

  /** Starts a renderer. If WebGPU fails, starts WebGL. */
  async #openCanvas(kind: RendererKind): Promise<CanvasStage> {
    const { messages, page } = this.#parts
    if (this.#canvas) closeCanvas(this.#canvas)
    this.#canvas = null
    try {
      this.#canvas = await openCanvas(page.viewport, kind)
    } catch (error) {
      if (kind === 'webgl') throw error
      messages.error(error)
      this.#canvas = await openCanvas(page.viewport, 'webgl')
    }
    return this.#canvas
  }

  /** Creates a viewer for an avatar. If that fails, shows the error and creates a viewer for the previous avatar. */
  #makeViewer(canvas: CanvasStage, avatar: OpenedAvatar, last: OpenedAvatar | undefined): Viewer {
    try {
      return new Viewer(canvas, avatar)
    } catch (error) {
      if (!last || last === avatar) throw error
      this.#parts.messages.error(error)
      return new Viewer(canvas, last)
    }
  }

  /** Disposes of the viewer, and returns a function that applies its settings to the next viewer. */
  #close(): ReturnType<typeof snapshot> | null {
    const [viewer, orbit] = [this.#viewer, this.#orbit]
    if (!viewer || !orbit) return null
    this.#parts.loop.stop()
    this.#watching.abort()
    const state = snapshot(viewer, orbit)
    this.#viewer = null
    this.#orbit = null
    orbit.dispose()
    viewer.dispose()
    return state
  }

  /** Opens another viewer when the WebGPU device is lost. After two losses in a short time, opens WebGL. */
  #watch(viewer: Viewer): void {
    const { messages, loop } = this.#parts
    const { renderer } = viewer.stage
    this.#watching = new AbortController()
    if (isWebGL(renderer)) {
      const { signal } = this.#watching
      viewer.canvas.addEventListener('webglcontextrestored', () => loop.wake(), { signal })
      viewer.canvas.addEventListener('webglcontextlost', () => messages.note(NOTE.graphicsLost), { signal })
      return
    }
    void deviceOf(renderer)?.lost.then(({ message }) => {
      if (this.#viewer !== viewer) return
      const isRepeated = performance.now() - this.#lastLoss < LOSS_WINDOW
      this.#lastLoss = performance.now()
      const remedy = isRepeated ? 'the studio now uses WebGL' : 'the device was started again'
      messages.error(`Studio: the graphics device was lost, got ${JSON.stringify(message)}; ${remedy}`)
      void this.open(isRepeated ? 'webgl' : 'webgpu')
    })
  }

  #resize(): void {
    const { page, loop } = this.#parts
    const { clientWidth: width, clientHeight: height } = page.viewport
    if (!this.#viewer || width === 0 || height === 0) return
    this.#viewer.stage.resize(width, height, Math.min(devicePixelRatio, 2))
    this.#orbit?.frame(true)
    loop.wake()
  }
}
