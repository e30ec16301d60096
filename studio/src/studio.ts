import { isWebGL } from '../../stage/light.ts'
import type { RendererKind } from '../../stage/stage.ts'
import { VIEWS, type ViewName } from '../../stage/views.ts'
import { adapterName, deviceOf, whyNot } from './adapter.ts'
import { readArea } from './area-file.ts'
import { Divider } from './divider.ts'
import { takeDrops } from './drop.ts'
import { fetchFace, type LoadedFace, listFaces } from './faces.ts'
import { Loading, painted } from './loading.ts'
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
import { spoken } from './words.ts'

/** Seconds from one expression to the next. */
const EXPRESSION_TIME = 0.35
/** Milliseconds within which a second loss of the device means that WebGPU cannot be had. */
const LOSS_WINDOW = 15_000

const reducedMotion = matchMedia('(prefers-reduced-motion: reduce)')

/** The page at work: does to the viewer what the controls ask, and shows what came of it. */
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
  /** Renderers are made one at a time: the next waits until the last has given its device back. */
  #opening: Promise<unknown> = Promise.resolve()
  #lost = Number.NEGATIVE_INFINITY

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
    this.#views = new Buttons(page.views, views, (name) => this.#turn(name), { 'three-quarter': '3/4' })
    this.#divider = new Divider(page.divider, page.stage, (share) => {
      if (this.#viewer) this.#viewer.split = share
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
      light: (areas) => this.#change((viewer) => viewer.light(areas)),
    })
    page.screenshot.addEventListener('click', () => this.#savePicture())
    takeDrops(page.dropping, (files) => this.#addAreas(files))
    new ResizeObserver(() => this.#resize()).observe(page.viewport)
  }

  /** Lists the faces and opens one: `?renderer=webgpu&face=human-2` in the page's address says which. */
  async start(): Promise<void> {
    this.#loading.show('Looking for faces')
    await this.#messages.attempt(async () => {
      const names = await listFaces()
      this.#panel.offer(names)
      const asked = new URLSearchParams(location.search)
      const name = names.find((known) => known === asked.get('face')) ?? names[0]
      await this.open(asked.get('renderer') === 'webgpu' ? 'webgpu' : 'webgl', name)
    })
    if (!this.#viewer) this.#loading.done()
    else this.#play('surprised')
  }

  /** Opens a renderer, and a face if it is another; all that was set stays. */
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
    const reason = await whyNot(kind)
    if (reason && this.#viewer?.kind === 'webgl') throw new Error(reason)
    if (reason) this.#messages.error(reason)
    const loaded = await this.#face(name)
    this.#loading.show(`Starting ${reason || kind === 'webgl' ? 'WebGL' : 'WebGPU'}`)
    await painted()
    const before = this.#close()
    const viewer = await this.#makeViewer(reason ? 'webgl' : kind, loaded)
    this.#viewer = viewer
    this.#orbit = new Orbit(viewer.stage, this.#page.viewport, reducedMotion.matches, () => this.#loop.wake())
    this.#resize()
    this.#orbit.goTo('front', true)
    viewer.split = this.#divider.share
    for (const step of before?.(viewer, this.#orbit) ?? []) await this.#messages.attempt(step)
    this.#panel.show(viewer)
    this.#showLabels()
    this.#watch(viewer)
    this.#meter.reset()
    this.#loop.start()
  }

  async #face(name: string | undefined): Promise<LoadedFace> {
    const now = this.#viewer?.loaded
    if (now && (name === undefined || now.name === name)) return now
    const title = spoken(name!)
    this.#loading.show(`Loading ${title}`, 0)
    return fetchFace(name!, (share) => this.#loading.show(`Loading ${title}`, share))
  }

  async #makeViewer(kind: RendererKind, loaded: LoadedFace): Promise<Viewer> {
    const make = (wanted: RendererKind) => {
      const canvas = document.createElement('canvas')
      this.#page.viewport.replaceChildren(canvas)
      return Viewer.create(canvas, wanted, loaded)
    }
    if (kind === 'webgl') return make(kind)
    try {
      return await make(kind)
    } catch (error) {
      this.#messages.error(error)
      return make('webgl')
    }
  }

  /** Ends the viewer; returns what puts its state on the next one. */
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

  /** A lost device is made anew once; where it is lost again at once, WebGL serves. */
  #watch(viewer: Viewer): void {
    const { renderer } = viewer.stage
    if (isWebGL(renderer)) {
      viewer.canvas.addEventListener('webglcontextrestored', () => this.#loop.wake())
      return
    }
    void deviceOf(renderer)?.lost.then(({ message }) => {
      if (this.#viewer !== viewer) return
      const again = performance.now() - this.#lost < LOSS_WINDOW
      this.#lost = performance.now()
      const remedy = again ? 'the face is on WebGL now' : 'it was started again'
      this.#messages.error(`Studio: the graphics device was lost, got ${JSON.stringify(message)}; ${remedy}`)
      void this.open(again ? 'webgl' : 'webgpu')
    })
  }

  #advance(delta: number): void {
    const moved = this.#viewer?.moving
    this.#viewer?.advance(delta)
    this.#orbit?.advance(delta)
    this.#views.show(this.#orbit?.view ?? null)
    if (moved) this.#panel.follow()
  }

  get #moving(): boolean {
    return (this.#viewer?.moving || this.#orbit?.moving) ?? false
  }

  #turn(name: ViewName): void {
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

  /** Moves sliders by hand; an expression that is on its way arrives first. */
  #set(write: () => void): void {
    this.#change((viewer) => {
      viewer.advance(Number.POSITIVE_INFINITY)
      write()
      this.#expression = null
      this.#panel.showExpression(null)
      this.#panel.follow()
    })
  }

  /** Does something to the viewer; what goes wrong is said, and the controls show how things stand then. */
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
        // At once in the picture, or nobody would see that anything happened.
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
