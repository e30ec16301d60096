import { isWebGL } from '../../stage/light.ts'
import type { RendererKind } from '../../stage/stage.ts'
import { VIEWS, type ViewName } from '../../stage/views.ts'
import { adapterName, deviceOf, unavailableReason } from './adapter.ts'
import { readArea } from './area-file.ts'
import { displayName } from './display-name.ts'
import { Divider } from './divider.ts'
import { acceptDrops } from './drop.ts'
import { fetchFace, type LoadedFace, listFaces } from './faces.ts'
import { Loading, nextPaint } from './loading.ts'
import { lookLabel } from './looks.ts'
import { Loop } from './loop.ts'
import { Messages } from './messages.ts'
import { Meter } from './meter.ts'
import { Orbit } from './orbit.ts'
import type { Page } from './page.ts'
import { Buttons } from './panel/buttons.ts'
import { Panel } from './panel/panel.ts'
import { savePicture } from './save-picture.ts'
import { snapshot } from './snapshot.ts'
import { Viewer } from './viewer.ts'

/** Seconds of the transition from one expression to another. */
const EXPRESSION_TIME = 0.35
/** Milliseconds: two device losses within this time mean that WebGPU does not work here. */
const LOSS_WINDOW = 15_000

const reducedMotion = matchMedia('(prefers-reduced-motion: reduce)')

/** The application: applies what the controls request to the viewer, and shows the result. */
export class Studio {
  readonly #page: Page
  readonly #messages: Messages
  readonly #loading: Loading
  readonly #panel: Panel
  readonly #views: Buttons<ViewName>
  readonly #divider: Divider
  readonly #meter: Meter
  readonly #loop: Loop
  #viewer: Viewer | null = null
  #orbit: Orbit | null = null
  #expression: string | null = null
  /** Renderers are created one at a time: each waits until the last one has released its device. */
  #opening: Promise<unknown> = Promise.resolve()
  #lastLoss = Number.NEGATIVE_INFINITY

  constructor(page: Page) {
    this.#page = page
    this.#messages = new Messages(page.errors, page.notes)
    this.#loading = new Loading(page)
    this.#meter = new Meter(page.frameTime, page.graph)
    this.#loop = new Loop(
      {
        advance: (delta) => this.#advance(delta),
        draw: () => this.#viewer?.draw(),
        moving: () => this.#moving,
      },
      this.#meter.add,
    )
    const views = Object.keys(VIEWS) as ViewName[]
    this.#views = new Buttons(page.views, views, (name) => this.#goTo(name), { 'three-quarter': '3/4' })
    this.#divider = new Divider(page.divider, page.stage, (position) => {
      if (this.#viewer) this.#viewer.split = position
      this.#loop.wake()
    })
    this.#panel = new Panel(page, {
      face: (name) => this.open(this.#viewer?.kind ?? 'webgl', name),
      renderer: (kind) => this.open(kind),
      mode: (mode) =>
        this.#change((viewer) => {
          viewer.mode = mode
        }),
      look: (look) =>
        this.#change((viewer) => {
          viewer.look = look
        }),
      play: (name) => this.#play(name),
      input: (dial, value) => this.#set(() => dial.write(value)),
      reset: (dials) =>
        this.#set(() => {
          for (const dial of dials) dial.write(0)
        }),
      addAreas: (files) => this.#addAreas(files),
      removeArea: (name) => this.#removeArea(name),
      highlight: (areas) => this.#change((viewer) => viewer.highlight(areas)),
    })
    page.screenshot.addEventListener('click', () => this.#savePicture())
    page.uvLayout.addEventListener('click', () => this.#saveUvLayout())
    acceptDrops(page.dropping, (files) => this.#addAreas(files))
    new ResizeObserver(() => this.#resize()).observe(page.viewport)
  }

  /** Lists the faces and opens the first, or the one that the URL names: `?renderer=webgpu&face=human-2`. */
  async start(): Promise<void> {
    this.#loading.show('Listing faces')
    await this.#messages.attempt(async () => {
      const names = await listFaces()
      this.#panel.setFaces(names)
      const query = new URLSearchParams(location.search)
      const name = names.find((known) => known === query.get('face')) ?? names[0]
      await this.open(query.get('renderer') === 'webgpu' ? 'webgpu' : 'webgl', name)
    })
    if (!this.#viewer) this.#loading.done()
    else this.#play('surprised')
  }

  /** Opens a renderer, with another face if one is named; the user's settings are kept. */
  open(kind: RendererKind, name?: string): Promise<unknown> {
    this.#opening = this.#opening.then(() =>
      this.#messages.attempt(async () => {
        try {
          await this.#open(kind, name)
        } finally {
          this.#loading.done()
          this.#panel.refresh()
        }
      }),
    )
    return this.#opening
  }

  async #open(kind: RendererKind, name: string | undefined): Promise<void> {
    const reason = await unavailableReason(kind)
    if (reason && this.#viewer?.kind === 'webgl') throw new Error(reason)
    if (reason) this.#messages.error(reason)
    const loaded = await this.#loadFace(name)
    this.#loading.show(`Starting ${reason || kind === 'webgl' ? 'WebGL' : 'WebGPU'}`)
    await nextPaint()
    const restore = this.#close()
    const viewer = await this.#makeViewer(reason ? 'webgl' : kind, loaded)
    this.#viewer = viewer
    this.#orbit = new Orbit(viewer.stage, this.#page.viewport, reducedMotion.matches, () => this.#loop.wake())
    this.#resize()
    this.#orbit.goTo('front', true)
    viewer.split = this.#divider.position
    for (const step of restore?.(viewer, this.#orbit) ?? []) await this.#messages.attempt(step)
    this.#panel.show(viewer)
    this.#showLabels()
    this.#watch(viewer)
    this.#meter.reset()
    this.#loop.start()
  }

  async #loadFace(name: string | undefined): Promise<LoadedFace> {
    const current = this.#viewer?.loaded
    if (current && (name === undefined || current.name === name)) return current
    const title = displayName(name!)
    this.#loading.show(`Loading ${title}`, 0)
    return fetchFace(name!, (fraction) => this.#loading.show(`Loading ${title}`, fraction))
  }

  async #makeViewer(kind: RendererKind, loaded: LoadedFace): Promise<Viewer> {
    const create = (createdKind: RendererKind) => {
      const canvas = document.createElement('canvas')
      this.#page.viewport.replaceChildren(canvas)
      return Viewer.create(canvas, createdKind, loaded)
    }
    if (kind === 'webgl') return create(kind)
    try {
      return await create(kind)
    } catch (error) {
      this.#messages.error(error)
      return create('webgl')
    }
  }

  /** Disposes of the viewer; returns what restores its state on the next one. */
  #close(): ReturnType<typeof snapshot> | null {
    const [viewer, orbit] = [this.#viewer, this.#orbit]
    if (!viewer || !orbit) return null
    this.#loop.stop()
    const state = snapshot(viewer, orbit)
    this.#viewer = null
    this.#orbit = null
    orbit.dispose()
    viewer.dispose()
    return state
  }

  /** Starts a lost device again, or falls back to WebGL if it is lost twice in a short time. */
  #watch(viewer: Viewer): void {
    const { renderer } = viewer.stage
    if (isWebGL(renderer)) {
      viewer.canvas.addEventListener('webglcontextrestored', () => this.#loop.wake())
      return
    }
    void deviceOf(renderer)?.lost.then(({ message }) => {
      if (this.#viewer !== viewer) return
      const isRepeated = performance.now() - this.#lastLoss < LOSS_WINDOW
      this.#lastLoss = performance.now()
      const remedy = isRepeated ? 'the face is on WebGL now' : 'it was started again'
      this.#messages.error(`Studio: the graphics device was lost, got ${JSON.stringify(message)}; ${remedy}`)
      void this.open(isRepeated ? 'webgl' : 'webgpu')
    })
  }

  #advance(delta: number): void {
    const wasMoving = this.#viewer?.moving
    this.#viewer?.advance(delta)
    this.#orbit?.advance(delta)
    this.#views.show(this.#orbit?.view ?? null)
    if (wasMoving) this.#panel.follow()
  }

  get #moving(): boolean {
    return (this.#viewer?.moving || this.#orbit?.moving) ?? false
  }

  #goTo(name: ViewName): void {
    this.#orbit?.goTo(name)
    this.#loop.wake()
  }

  #play(name: string): void {
    this.#change((viewer) => {
      viewer.play(name, reducedMotion.matches ? 0 : EXPRESSION_TIME)
      this.#expression = name
      this.#panel.showExpression(name)
      this.#panel.follow()
    })
  }

  /** Sets sliders by hand, after finishing the transition to an expression. */
  #set(write: () => void): void {
    this.#change((viewer) => {
      viewer.advance(Number.POSITIVE_INFINITY)
      write()
      this.#expression = null
      this.#panel.showExpression(null)
      this.#panel.follow()
    })
  }

  /** Changes the viewer; shows errors, and updates the controls to the state that results. */
  #change(task: (viewer: Viewer) => void): void {
    const viewer = this.#viewer
    if (!viewer) return
    void this.#messages
      .attempt(() => task(viewer))
      .then(() => {
        this.#panel.refresh()
        this.#showLabels()
        this.#loop.wake()
      })
  }

  async #addAreas(files: File[]): Promise<void> {
    const { convention } = this.#panel
    for (const file of files) {
      await this.#messages.attempt(async () => {
        const area = await readArea(file, convention)
        const viewer = this.#viewer
        if (!viewer) return
        viewer.addArea(area)
        // Fully active, so that the new area is visible at once.
        viewer.wrinkles.setActivation(area.name, 1)
        this.#panel.show(viewer)
        this.#messages.note(`Added area ${area.name}`)
        this.#loop.wake()
      })
    }
  }

  #removeArea(name: string): void {
    this.#change((viewer) => {
      viewer.removeArea(name)
      this.#panel.show(viewer)
      this.#messages.note(`Removed area ${name}`)
    })
  }

  async #savePicture(): Promise<void> {
    await this.#messages.attempt(async () => {
      const viewer = this.#viewer
      if (!viewer) return
      viewer.draw()
      const words = ['furrow', viewer.loaded.name, this.#expression, viewer.look.name]
      await savePicture(viewer.canvas, `${words.filter(Boolean).join('-')}.png`)
      this.#messages.note('Saved the picture')
    })
  }

  async #saveUvLayout(): Promise<void> {
    await this.#messages.attempt(async () => {
      const viewer = this.#viewer
      if (!viewer) return
      const { drawUvPicture } = await import('./uv-picture.ts')
      await savePicture(drawUvPicture(viewer.wrinkles.mesh), `${viewer.loaded.name}-uv.png`)
      this.#messages.note('Saved the UV layout: paint over it')
    })
  }

  #resize(): void {
    const viewer = this.#viewer
    const { clientWidth: width, clientHeight: height } = this.#page.viewport
    if (!viewer || width === 0 || height === 0) return
    viewer.stage.resize(width, height, Math.min(devicePixelRatio, 2))
    if (this.#orbit?.view) this.#orbit.goTo(this.#orbit.view, true)
    this.#loop.wake()
  }

  #showLabels(): void {
    const viewer = this.#viewer
    if (!viewer) return
    this.#page.sideWith.textContent = lookLabel(viewer.look, viewer.mode)
    this.#page.backend.textContent = viewer.stage.backend
    this.#page.adapter.textContent = adapterName(viewer.stage.renderer)
    this.#page.adapter.title = this.#page.adapter.textContent
  }
}
