import { batch, effect, signal, untracked } from '@preact/signals'
import type { AreaConvention } from 'furrow'
import { VIEWS, type ViewName } from '../../stage/views.ts'
import { readArea } from './area-file.ts'
import { Buttons } from './buttons.ts'
import { displayName } from './display-name.ts'
import { Divider } from './divider.ts'
import type { StudioDocument } from './document/document.ts'
import { Downloads } from './downloads.ts'
import { acceptFiles } from './drop.ts'
import { Lines } from './lines/lines.ts'
import { PageLink } from './link/page-link.ts'
import { Loading } from './loading.ts'
import { Loop } from './loop.ts'
import { Messages } from './messages.ts'
import { Meter } from './meter.ts'
import { reducedMotion } from './motion.ts'
import { type OpenedAvatar, openDropped } from './open/avatar.ts'
import { type DroppedFile, filesOfInput, filesOfTransfer } from './open/dropped-files.ts'
import { sortFiles } from './open/sort-files.ts'
import type { Page } from './page.ts'
import type { Hovered, PanelModel } from './panels/model.ts'
import { showPanel } from './panels/show-panel.tsx'
import { AreaEditor } from './session/area-editor.ts'
import { LayerEditor } from './session/layer-editor.ts'
import { Saving } from './session/saving.ts'
import { Workspace } from './session/workspace.ts'
import { addShortcuts } from './shortcuts.ts'
import { TextureToggle } from './texture/texture-toggle.ts'
import { Painting } from './tools/painting.ts'
import { ToolHost } from './tools/tool-host.ts'
import { adapterName } from './viewer/adapter.ts'
import { DocumentView, type DrawnDocument } from './viewer/document-view.ts'
import { fetchFace, listFaces } from './viewer/faces.ts'
import { lookLabel } from './viewer/looks.ts'
import { Performer } from './viewer/performer.ts'
import { Staging } from './viewer/staging.ts'
import type { Viewer } from './viewer/viewer.ts'
import { type LoadAvatar, ViewerHost } from './viewer/viewer-host.ts'

/** Seconds of the transition from one expression to another. */
const EXPRESSION_TIME = 0.35

/** The application: applies what the controls request, and shows the result. */
export class Studio {
  readonly #page: Page
  readonly #messages: Messages
  readonly #loading: Loading
  readonly #views: Buttons<ViewName>
  readonly #divider: Divider
  readonly #meter: Meter
  readonly #loop: Loop
  readonly #host: ViewerHost

  readonly #workspace: Workspace
  readonly #saving: Saving
  readonly #link: PageLink
  readonly #isListOpen = signal(false)
  readonly #areas: AreaEditor
  readonly #layers: LayerEditor
  readonly #staging: Staging
  readonly #performer: Performer
  readonly #tools: ToolHost
  readonly #painting: Painting
  readonly #view = new DocumentView()
  readonly #lines: Lines
  readonly #downloads: Downloads
  readonly #faces = signal<readonly string[]>([])
  readonly #shown = signal<Viewer | null>(null)
  readonly #frame = signal(0)
  readonly #revision = signal(0)
  readonly #expression = signal<string | null>(null)
  readonly #hovered = signal<Hovered | null>(null)

  constructor(page: Page) {
    this.#page = page
    const messages = new Messages(page.errors, page.notes)
    const loading = new Loading(page)
    this.#messages = messages
    this.#loading = loading
    this.#meter = new Meter(page.frameTime, page.graph)
    this.#loop = new Loop(
      {
        advance: (delta) => this.#advance(delta),
        draw: () => {
          this.#viewer?.draw()
          this.#lines.draw()
        },
        moving: () => this.#moving,
      },
      this.#meter.add,
    )
    this.#host = new ViewerHost({
      page,
      messages,
      loading,
      loop: this.#loop,
      onOpen: (viewer) => this.#show(viewer),
      onSettled: () => this.#refresh(),
    })
    const views = Object.keys(VIEWS) as ViewName[]
    this.#views = new Buttons(page.views, views, (name) => this.#goTo(name), { 'three-quarter': '3/4' })
    this.#divider = new Divider(page.divider, page.stage, (position) => {
      if (this.#viewer) this.#viewer.split = position
      this.#loop.wake()
    })
    this.#workspace = new Workspace((error) => messages.error(error))
    this.#saving = new Saving(this.#workspace)
    this.#downloads = new Downloads(this.#workspace, this.#saving, messages)
    this.#link = new PageLink({
      host: this.#host,
      workspace: this.#workspace,
      messages,
      loading,
      set: (write) => this.#set(write),
    })
    const { session } = this.#workspace
    this.#areas = new AreaEditor(session, (task) => void messages.attempt(task))
    this.#layers = new LayerEditor({
      session,
      drawn: this.#workspace.drawn,
      avatar: () => this.#viewer?.avatar ?? null,
      attempt: (task) => messages.attempt(task),
    })
    this.#staging = new Staging({
      viewer: this.#shown,
      orbit: () => this.#host.orbit,
      wake: () => this.#loop.wake(),
    })
    this.#performer = new Performer({
      viewer: this.#shown,
      isSideLit: this.#staging.isSideLit,
      onPose: () => {
        this.#frame.value++
        this.#loop.wake()
      },
    })
    this.#tools = new ToolHost(page.viewport, () => this.#viewer?.stage.camera ?? null)
    this.#painting = new Painting({
      session,
      areas: this.#areas,
      viewer: this.#shown,
      frame: this.#frame,
      host: this.#tools,
      stage: page.stage,
      wake: () => this.#loop.wake(),
      attempt: (task) => messages.attempt(task),
    })
    this.#lines = new Lines({
      stage: page.viewport,
      session,
      viewer: this.#shown,
      tools: this.#tools,
      wake: () => this.#loop.wake(),
      attempt: (task) => void messages.attempt(task),
    })
    new TextureToggle(page.textureToggle, {
      element: page.texture,
      session,
      areas: this.#areas,
      painting: this.#painting,
      viewer: this.#shown,
      attempt: (task) => messages.attempt(task),
    })
    // One tool at a time.
    effect(() => {
      if (this.#painting.area.value !== null) this.#lines.editor.mode.value = 'off'
    })
    effect(() => {
      if (this.#lines.editor.mode.value !== 'off') this.#painting.isOn = false
    })
    showPanel(page.panel, this.#panelModel())
    effect(() => this.#highlight(this.#hovered.value, this.#painting.area.value))
    effect(() => {
      const hovered = this.#hovered.value
      const area = hovered?.kind === 'area' && !this.#isEdited ? hovered.name : null
      untracked(() => this.#performer.request(area))
    })
    effect(() => {
      this.#arrange(this.#shown.value, this.#areas.hidden.value, this.#isEdited)
    })
    effect(() => this.#showDocument(this.#shown.value, this.#workspace.drawn.value))
    addShortcuts({
      undo: () => session.undo(),
      redo: () => session.redo(),
      save: () => this.#downloads.save(),
      list: () => {
        this.#isListOpen.value = true
      },
    })
    page.screenshot.addEventListener('click', () =>
      this.#downloads.picture(this.#viewer, this.#expression.peek()),
    )
    page.uvLayout.addEventListener('click', () => this.#downloads.uvLayout(this.#viewer))
    acceptFiles(page.dropping, (files) => this.#openFiles(() => filesOfTransfer(files)))
  }

  /** Lists the faces and opens the first, or the one that the URL names: `?renderer=webgpu&face=human-2`. */
  async start(): Promise<void> {
    this.#loading.show('Listing faces')
    await this.#messages.attempt(async () => {
      this.#faces.value = await listFaces()
      const query = new URLSearchParams(location.search)
      const name = this.#faces.value.find((known) => known === query.get('face')) ?? this.#faces.value[0]
      const kind = query.get('renderer') === 'webgpu' ? 'webgpu' : 'webgl'
      await this.#link.read()
      await this.#host.open(kind, this.#link.load ?? this.#fetch(name))
      if (!this.#viewer && this.#link.load) await this.#host.open(kind, this.#fetch(name))
    })
    if (!this.#viewer) this.#loading.done()
    else if (!this.#link.show()) this.#play('surprised')
  }

  #panelModel(): PanelModel {
    const { session, automatic, exporting, keeping, settings } = this.#workspace
    return {
      session,
      lines: this.#lines.editor,
      areas: this.#areas,
      layers: this.#layers,
      painting: this.#painting,
      auto: settings,
      autoRun: automatic.run,
      exporting: exporting.state,
      projects: keeping.projects,
      saving: keeping.state,
      folder: this.#saving.folder,
      isListOpen: this.#isListOpen,
      faces: this.#faces,
      viewer: this.#shown,
      frame: this.#frame,
      revision: this.#revision,
      expression: this.#expression,
      hovered: this.#hovered,
      staging: this.#staging,
      actions: {
        attempt: (task) => void this.#messages.attempt(task),
        openFiles: (files) => this.#openFiles(async () => filesOfInput(files)),
        openFace: (name) => this.#open(this.#fetch(name)),
        chooseSkin: (skin) => this.#open(async (shown) => ({ ...shown!, skin })),
        setRenderer: (kind) => {
          this.#performer.settle()
          return this.#host.open(kind)
        },
        setMode: (mode) =>
          this.#change((viewer) => {
            viewer.mode = mode
          }),
        setLook: (look) =>
          this.#change((viewer) => {
            viewer.look = look
          }),
        play: (name) => this.#play(name),
        pose: () => {
          this.#performer.settle()
          return new Map(this.#viewer?.targets.map((dial) => [dial.name, dial.read()]))
        },
        input: (dial, value) => this.#set(() => dial.write(value)),
        reset: (dials) =>
          this.#set(() => {
            for (const dial of dials) dial.write(0)
          }),
        addAreaImages: (files, convention) => this.#addAreas(files, convention),
        removeArea: (name) => this.#removeArea(name),
        previewAuto: (next) => void this.#messages.attempt(() => this.#workspace.previewAuto(next)),
        makeAuto: (next) => void this.#messages.attempt(() => this.#workspace.makeAuto(next)),
        cancelAuto: () => this.#workspace.cancelAuto(),
        editWrinkles: () => void this.#messages.attempt(() => this.#workspace.editWrinkles()),
        openProject: (id) => this.#open(() => this.#openProject(id)),
        keepCopy: () => void this.#messages.attempt(() => keeping.copy()),
        takeOver: () => this.#open(() => this.#takeOver()),
        deleteProject: (id) => void this.#messages.attempt(() => keeping.delete(id)),
        exportFace: (options) => void this.#messages.attempt(() => this.#workspace.export(options)),
        cancelExport: () => exporting.cancel(),
        saveExport: () => this.#downloads.export(),
        saveProject: () => void this.#downloads.project(),
        saveToFolder: (isOther) => void this.#downloads.folder(isOther),
        copyLink: () => void this.#messages.attempt(() => this.#link.copy()),
      },
    }
  }

  /** Null for a face whose wrinkles are not a document's. */
  get #document(): StudioDocument | null {
    return this.#workspace.session.document.peek()
  }

  get #viewer(): Viewer | null {
    return this.#host.viewer
  }

  /** One of the faces on the server. */
  #fetch(name: string): LoadAvatar {
    const title = `Loading ${displayName(name)}`
    return () => {
      this.#loading.show(title, 0)
      return fetchFace(name, (fraction) => this.#loading.show(title, fraction))
    }
  }

  #openProject(id: string): Promise<OpenedAvatar> {
    this.#loading.show('Opening')
    return this.#workspace.openProject(id)
  }

  /** Opens the project again that another tab has, as that has saved it. */
  async #takeOver(): Promise<OpenedAvatar> {
    this.#loading.show('Opening')
    const project = await this.#workspace.keeping.project()
    return this.#workspace.openProject(project!.id, true)
  }

  #open(load: LoadAvatar): Promise<unknown> {
    this.#performer.settle()
    return this.#host.open(this.#viewer?.kind ?? 'webgl', load)
  }

  /**
   * Opens what was dropped: an avatar, wrinkles for the one on the stage, or areas.
   *
   * @param list is called at once: what was dropped is gone after its event.
   */
  async #openFiles(list: () => Promise<DroppedFile[]>): Promise<void> {
    await this.#messages.attempt(async () => {
      const dropped = await sortFiles(await list())
      if (dropped.kind === 'areas') {
        const images = dropped.images.map(({ file }) => file)
        return this.#addAreas(images, 'paper')
      }
      await this.#open(async (shown) => {
        const name = dropped.kind === 'avatar' ? dropped.face.file.name : dropped.wrinkles.name
        this.#loading.show(`Loading ${name}`)
        const avatar = await openDropped(dropped, shown)
        this.#messages.note(avatar.notes.join('. '))
        return avatar
      })
    })
  }

  #show(viewer: Viewer): void {
    if (viewer.avatar.root !== this.#shown.peek()?.avatar.root) this.#expression.value = null
    // Together: the last document is never shown on the next face.
    batch(() => {
      void this.#messages.attempt(() => this.#workspace.open(viewer.avatar))
      this.#shown.value = viewer
    })
    this.#refresh()
    this.#meter.reset()
  }

  /** Shows what is worked on; a face that has wrinkles of its own and no document is left as it is. */
  #showDocument(viewer: Viewer | null, drawn: DrawnDocument | null): void {
    if (!viewer || (!drawn && viewer.avatar.skins[viewer.avatar.skin].wrinkles)) return
    void this.#messages
      .attempt(() => this.#view.show(viewer, drawn))
      .then(() => {
        this.#refresh()
        this.#loop.wake()
      })
  }

  #advance(delta: number): void {
    const wasMoving = this.#viewer?.moving
    this.#viewer?.advance(delta)
    this.#performer.advance(delta)
    this.#painting.advance()
    this.#host.orbit?.advance(delta)
    this.#views.show(this.#host.orbit?.view ?? null)
    if (wasMoving) this.#frame.value++
  }

  get #moving(): boolean {
    return (this.#viewer?.moving || this.#performer.moving || this.#host.orbit?.moving) ?? false
  }

  /** Whether the pointer paints or draws on the face, which then holds still. */
  get #isEdited(): boolean {
    return this.#painting.area.value !== null || this.#lines.editor.mode.value !== 'off'
  }

  #goTo(name: ViewName): void {
    this.#host.orbit?.goTo(name)
    this.#loop.wake()
  }

  #play(name: string): void {
    this.#change((viewer) => {
      this.#performer.settle()
      viewer.play(name, reducedMotion.matches ? 0 : EXPRESSION_TIME)
      this.#expression.value = name
      this.#frame.value++
    })
  }

  /** Sets sliders by hand, after finishing the transition to an expression. */
  #set(write: () => void): void {
    this.#change((viewer) => {
      this.#performer.settle()
      viewer.advance(Number.POSITIVE_INFINITY)
      write()
      this.#expression.value = null
      this.#frame.value++
    })
  }

  /** Changes the viewer; shows errors, and updates the controls to the state that results. */
  #change(task: (viewer: Viewer) => void): void {
    const viewer = this.#viewer
    if (!viewer) return
    void this.#messages
      .attempt(() => task(viewer))
      .then(() => {
        this.#refresh()
        this.#loop.wake()
      })
  }

  /** Leaves muted areas out. Painting needs the whole face: what is painted is shown on the side with wrinkles. */
  #arrange(viewer: Viewer | null, hidden: readonly string[], isEdited: boolean): void {
    if (!viewer) return
    viewer.hidden = hidden
    viewer.split = isEdited ? 0 : this.#divider.position
    this.#loop.wake()
  }

  /** Shows which areas the pointer or focus is on, or which ones the blendshape moves, or else the one that is painted. */
  #highlight(hovered: Hovered | null, painted: string | null): void {
    const viewer = this.#shown.value
    if (!viewer) return
    if (!hovered) viewer.highlight(painted === null ? [] : [painted])
    else if (hovered.kind === 'target') viewer.highlight(viewer.drivenBy(hovered.name))
    // The face performs instead, where it can.
    else if (painted === null && viewer.performanceOf(hovered.name)) viewer.highlight([])
    else viewer.highlight([hovered.name])
    this.#loop.wake()
  }

  async #addAreas(files: readonly File[], convention: AreaConvention): Promise<void> {
    for (const file of files) {
      await this.#messages.attempt(async () => {
        const area = await readArea(file, convention)
        const viewer = this.#viewer
        if (!viewer) return
        if (this.#document) return this.#areas.add(area)
        viewer.addArea(area)
        // Fully active, so that the new area is visible at once.
        viewer.wrinkles?.setActivation(area.name, 1)
        this.#refresh()
        this.#messages.note(`Added area ${area.name}`)
        this.#loop.wake()
      })
    }
  }

  #removeArea(name: string): void {
    this.#change((viewer) => {
      this.#hovered.value = null
      if (this.#document) this.#areas.remove(name)
      else viewer.removeArea(name)
      this.#messages.note(`Removed area ${name}`)
    })
  }

  /** Updates the controls and labels to the viewer. */
  #refresh(): void {
    this.#revision.value++
    this.#frame.value++
    const viewer = this.#viewer
    if (!viewer) return
    this.#page.sideWith.textContent = lookLabel(viewer.look, viewer.mode)
    this.#page.backend.textContent = viewer.stage.backend
    this.#page.adapter.textContent = adapterName(viewer.stage.renderer)
    this.#page.adapter.title = this.#page.adapter.textContent
  }
}
