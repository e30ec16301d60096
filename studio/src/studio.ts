import { batch, computed, effect, signal } from '@preact/signals'
import type { GrayImage } from 'furrow'
import { VIEWS, type ViewName } from '../../stage/views.ts'
import { Buttons } from './buttons.ts'
import { Divider } from './divider.ts'
import { Downloads } from './downloads.ts'
import { acceptFiles } from './drop.ts'
import { filesOfTransfer } from './files/dropped-files.ts'
import { Hints } from './first/hints.ts'
import { type Place, Resume } from './first/resume.ts'
import { Reveal } from './first/reveal.ts'
import { keepFocus } from './keep-focus.ts'
import { jointLabel, POSES } from './labels/joints.ts'
import { FULL_TAKE } from './labels/live.ts'
import { PROGRESS } from './labels/messages.ts'
import { moreLabel, PAGE } from './labels/page.ts'
import { VIEW_NAMES } from './labels/stage.ts'
import { nextTask } from './later.ts'
import { FillOffer } from './lines/fill-offer.ts'
import { Lines } from './lines/lines.ts'
import { PageLink } from './link/page-link.ts'
import { Live } from './live/live.ts'
import { loadSource } from './live/load-source.ts'
import { Loading } from './loading.ts'
import { Loop } from './loop.ts'
import { Messages } from './messages.ts'
import { Meter } from './meter.ts'
import type { Page } from './page.ts'
import { panelModel } from './panel-model.ts'
import { bindTools } from './pointer/bind-tools.ts'
import { FacePointer } from './pointer/face-pointer.ts'
import { saveFile } from './save-file.ts'
import { AreaEditor } from './session/area-editor.ts'
import { FaceAreas } from './session/face-areas.ts'
import { ImageImport } from './session/image-import.ts'
import { LayerEditor } from './session/layer-editor.ts'
import { Opening } from './session/opening.ts'
import { Saving } from './session/saving.ts'
import { ShapeEditor } from './session/shape-editor.ts'
import { TakeEditor } from './session/take-editor.ts'
import { Workspace } from './session/workspace.ts'
import { showShell } from './shell/shell.tsx'
import { addShortcuts } from './shortcuts.ts'
import { isStatisticsShown } from './statistics.ts'
import { TextureToggle } from './texture/texture-toggle.ts'
import { FaceSkin } from './tools/face-skin.ts'
import { Painting } from './tools/painting.ts'
import { Sculpting } from './tools/sculpting.ts'
import { ToolChoice } from './tools/tool-choice.ts'
import { ToolHost } from './tools/tool-host.ts'
import { adapterName } from './viewer/adapter.ts'
import { DocumentView, type DrawnDocument } from './viewer/document-view.ts'
import { listFaces } from './viewer/faces.ts'
import { lookLabel } from './viewer/looks/look-label.ts'
import { ShownFace } from './viewer/shown-face.ts'
import { shownPoses } from './viewer/shown-poses.ts'
import { SkeletonOverlay } from './viewer/skeleton/skeleton-overlay.ts'
import type { Viewer } from './viewer/viewer.ts'
import { type LoadAvatar, ViewerHost } from './viewer/viewer-host.ts'

/** Application: creates all parts of the studio and connects them. */
export class Studio {
  readonly #page: Page
  readonly #messages: Messages
  readonly #loading: Loading
  readonly #views: Buttons<ViewName>
  readonly #divider: Divider
  readonly #meter: Meter
  readonly #loop: Loop
  readonly #host: ViewerHost
  readonly #face: ShownFace
  readonly #opening: Opening

  readonly #workspace: Workspace
  readonly #link: PageLink
  readonly #resume: Resume
  readonly #reveal: Reveal
  readonly #painting: Painting
  readonly #sculpting: Sculpting
  readonly #view = new DocumentView()
  readonly #lines: Lines
  readonly #skeleton: SkeletonOverlay
  readonly #tools = new ToolChoice()
  readonly #faces = signal<readonly string[]>([])

  constructor(page: Page) {
    this.#page = page
    const messages = new Messages(page.errors, page.notes, { dismiss: PAGE.dismiss, more: moreLabel })
    const loading = new Loading(page)
    const dialogs = { shortcuts: signal(false), preferences: signal(false) }
    this.#messages = messages
    this.#loading = loading
    this.#meter = new Meter(page.frameTime, page.graph)
    this.#loop = new Loop(
      {
        advance: (delta) => this.#advance(delta),
        draw: () => {
          this.#viewer?.draw()
          this.#lines.draw()
          this.#skeleton.draw()
        },
        isMoving: () => this.#isMoving,
      },
      this.#meter.add,
    )
    this.#host = new ViewerHost({
      page,
      messages,
      loading,
      loop: this.#loop,
      onOpen: (viewer) => this.#show(viewer),
      onSettled: () => this.#face.refresh(),
    })
    const wake = () => this.#loop.wake()
    const attempt = (task: () => unknown) => messages.attempt(task)
    this.#face = new ShownFace({
      live: () => this.#host.viewer,
      orbit: () => this.#host.orbit,
      uncover: (x) => this.#divider.uncover(x),
      messages,
      wake,
    })
    const views = Object.keys(VIEWS) as ViewName[]
    this.#views = new Buttons(page.views, views, (name) => this.#goTo(name), VIEW_NAMES)
    this.#divider = new Divider(page.divider, page.stage, (position) => {
      if (this.#viewer) this.#viewer.split = position
      this.#loop.wake()
    })
    this.#workspace = new Workspace((error) => messages.error(error))
    const saving = new Saving(this.#workspace)
    const downloads = new Downloads(this.#workspace, saving, messages)
    this.#link = new PageLink({
      host: this.#host,
      workspace: this.#workspace,
      messages,
      loading,
      light: this.#face.staging.light,
      set: (write) => this.#face.set(write),
    })
    const { session } = this.#workspace
    const areas = new AreaEditor(session, (task) => void messages.attempt(task))
    const layers = new LayerEditor({
      session,
      work: () => this.#workspace.drawnWork(),
      avatar: () => this.#viewer?.avatar ?? null,
      attempt,
    })
    const faceAreas = new FaceAreas(this.#face, areas, messages)
    const images = new ImageImport({
      session,
      faceAreas,
      layers,
      messages,
      layer: () => (this.#lines.editor.chosen.peek() ?? areas.chosen.peek())?.layer,
      editWrinkles: () => this.#workspace.editWrinkles(),
    })
    const takes = new TakeEditor({
      session,
      player: this.#face.player,
      viewer: this.#face.viewer,
      ready: () => this.#workspace.editable(),
      saveFile,
      attempt,
    })
    const live = new Live({
      pose: this.#face.live,
      load: loadSource,
      ready: () => this.#workspace.editable(),
      onTake: (motion) => takes.add(motion),
      onFull: () => messages.note(FULL_TAKE),
      onError: (error) => messages.error(error),
    })
    this.#opening = new Opening({
      host: this.#host,
      face: this.#face,
      workspace: this.#workspace,
      messages,
      loading,
      askImages: (files) => images.ask(files),
      addCapture: (capture) => takes.open(capture),
      onDropped: (avatar) => this.#reveal.await(avatar),
    })
    const tools = new ToolHost(page.viewport, () => this.#viewer?.stage.camera ?? null)
    const skin = new FaceSkin({ session, viewer: this.#face.viewer, wake, attempt })
    this.#painting = new Painting({
      session,
      areas,
      viewer: this.#face.viewer,
      face: skin,
      host: tools,
      stage: page.stage,
      wake,
      onPainted: (area) => fill.painted(area),
      attempt,
    })
    const fill = new FillOffer({
      session,
      areas,
      canvas: async () => (await this.#lines.readySkin())?.canvas ?? null,
      onFilled: () => this.#painting.uncover(),
      attempt,
    })
    this.#sculpting = new Sculpting({
      session,
      areas,
      viewer: this.#face.viewer,
      face: skin,
      host: tools,
      stage: page.stage,
      wake,
      attempt,
    })
    const pointer = new FacePointer({
      stage: page.viewport,
      session,
      face: this.#face,
      areas,
      lines: () => this.#lines,
      edit: () => {
        if (this.#viewer?.wrinkles) void attempt(() => this.#workspace.editWrinkles())
      },
    })
    this.#lines = new Lines({
      stage: page.viewport,
      session,
      viewer: this.#face.viewer,
      tools,
      isMoving: () => this.#isMoving,
      onSkin: (hit) => pointer.point(hit),
      attempt,
    })
    this.#skeleton = new SkeletonOverlay({
      stage: page.viewport,
      viewer: this.#face.viewer,
      set: (write) => this.#face.set(write),
      wake,
      label: POSES.skeleton,
      nameOf: jointLabel,
    })
    this.#resume = new Resume({
      host: this.#host,
      workspace: this.#workspace,
      link: this.#link,
      meshes: this.#face.meshes,
    })
    const { chosen } = this.#lines.editor
    const hints = new Hints({
      isSelected: computed(() => areas.chosen.value !== null || chosen.value !== null),
      undoLabel: session.undoLabel,
      expression: this.#face.expression,
    })
    this.#reveal = new Reveal({
      face: this.#face,
      moveDivider: (position) => this.#divider.move(position),
      onEnd: () => hints.start(),
    })
    new TextureToggle(page.textureToggle, {
      element: page.texture,
      session,
      areas,
      painting: this.#painting,
      sculpting: this.#sculpting,
      lines: this.#lines,
      viewer: this.#face.viewer,
      attempt,
    })
    bindTools(this.#tools, {
      session,
      areas,
      painting: this.#painting,
      sculpting: this.#sculpting,
      lines: this.#lines.editor,
    })
    effect(() => this.#workspace.prepareEdit(this.#lines.editor.chosen.value))
    showShell(
      panelModel({
        workspace: this.#workspace,
        saving,
        face: this.#face,
        skeleton: this.#skeleton,
        lines: this.#lines,
        areas,
        faceAreas,
        images,
        layers,
        shapes: new ShapeEditor(session, this.#workspace.source),
        painting: this.#painting,
        fill,
        sculpting: this.#sculpting,
        tools: this.#tools,
        opening: this.#opening,
        host: this.#host,
        downloads,
        link: this.#link,
        messages,
        faces: this.#faces,
        dialogs,
        hints,
        live,
        takes,
      }),
    )
    keepFocus(document.body)
    effect(() => this.#face.highlight(this.#painting.highlighted.value))
    effect(() => {
      const hovered = this.#face.hovered.value
      this.#face.perform(this.#isEdited ? null : hovered)
    })
    // Pause the clip and the live pose while the face is edited.
    effect(() => {
      this.#face.isEdited.value = this.#isEdited
      if (this.#isEdited) this.#face.player.pause()
    })
    effect(() => {
      // A pointed region shows its wrinkles on both sides of the divider.
      const isPointed = this.#face.hovered.value?.isOnFace ?? false
      page.viewport.classList.toggle('pointed', isPointed)
      this.#arrange(this.#face.viewer.value, areas.hidden.value, this.#isEdited || isPointed)
    })
    effect(() => {
      this.#face.revision.value
      this.#label()
    })
    effect(() => this.#showDocument(this.#face.viewer.value, this.#workspace.drawn.value))
    addShortcuts({
      undo: () => session.undo(),
      redo: () => session.redo(),
      save: () => downloads.save(),
      list: () => {
        dialogs.shortcuts.value = true
      },
      overlay: () => {
        this.#lines.isShown.value = !this.#lines.isShown.peek()
      },
      wrinkles: () =>
        this.#face.change((viewer) => {
          viewer.mode = viewer.mode === 'off' ? 'default' : 'off'
        }),
      frame: () => this.#frameSelection(areas.chosen.peek()?.weights ?? null),
      expression: (number) => {
        const shown = this.#viewer && shownPoses(this.#viewer)[number - 1]
        if (shown?.kind === 'expression') this.#face.play(shown.name)
        else if (shown) this.#face.playPose(shown.name)
      },
      motion: (name) => {
        if (this.#tools.mode.peek() !== 'motion') return false
        if (name === 'record') void attempt(() => live.toggleRecording())
        else if (name !== 'play') takes.trimAtTime(name)
        else if (live.recorded.peek() === null) this.#face.player.toggle()
        return true
      },
      tool: (name) => {
        if (!session.document.peek() && name !== 'select') return
        if (name === 'mirror') this.#tools.mirror.value = !this.#tools.mirror.peek()
        else this.#tools.choose(name)
      },
    })
    effect(() => {
      page.readout.hidden = !isStatisticsShown.value
    })
    acceptFiles(page.dropping, (files) => this.#opening.openFiles(() => filesOfTransfer(files)))
  }

  /**
   * After a reload, continues where the user was. Otherwise opens the model of the link in the URL's hash, or the shipped face that the query
   * names (`?face=human-2`). Without these, the empty stage offers files and faces. `?renderer=webgpu` chooses the renderer.
   */
  async start(): Promise<void> {
    this.#loading.show(PROGRESS.faces)
    const query = new URLSearchParams(location.search)
    if (query.get('renderer') === 'webgpu') this.#opening.firstKind = 'webgpu'
    const place = this.#resume.read()
    await this.#messages.attempt(async () => {
      this.#faces.value = await listFaces()
      await this.#link.read()
      const [first] = this.#faces.value
      const face = query.get('face') ?? (this.#link.isGiven ? first : null)
      const load = (place && this.#loaderOf(place)) ?? this.#link.load ?? this.#faceLoader(face)
      if (load) await this.#opening.open(load)
    })
    this.#loading.done()
    if (!this.#viewer) return
    if (place) {
      this.#link.restore(place.scene)
      this.#face.meshes.restore(this.#viewer, place.hidden)
    } else if (!this.#link.show()) this.#face.play('surprised')
  }

  /** Returns a function that loads the project or the face of a place, or null if the place has neither. */
  #loaderOf({ project, face }: Place): LoadAvatar | null {
    if (project !== undefined) return () => this.#workspace.openProject(project)
    return this.#faceLoader(face)
  }

  /** Returns a function that loads a shipped face, or null if there is none with this name. */
  #faceLoader(name: string | null | undefined): LoadAvatar | null {
    const known = this.#faces.value.find((each) => each === name)
    return known === undefined ? null : this.#opening.faceLoader(known)
  }

  get #viewer(): Viewer | null {
    return this.#host.viewer
  }

  #show(viewer: Viewer): void {
    // Batch the changes, so that the old document is never shown on the new face.
    batch(() => {
      void this.#messages.attempt(() => this.#workspace.open(viewer.avatar))
      this.#face.show(viewer)
    })
    this.#face.refresh()
    this.#reveal.begin(viewer)
    this.#meter.reset()
  }

  /** Shows the wrinkles of the document. Without a document, keeps the wrinkles of the avatar's file. */
  #showDocument(viewer: Viewer | null, drawn: DrawnDocument | null): void {
    if (!viewer || (!drawn && viewer.avatar.skins[viewer.avatar.skin].wrinkles)) return
    const wasPlain = !viewer.wrinkles
    void this.#messages
      .attempt(() => this.#view.show(viewer, drawn))
      .then(async () => {
        const isOther = wasPlain === !!viewer.wrinkles
        // Fitting the face into the view reads all blendshapes and blocks the page, so let the browser handle pending events first.
        if (isOther) await nextTask()
        if (isOther && viewer === this.#viewer) this.#host.orbit?.frame()
        this.#face.refresh()
        if (viewer === this.#viewer) this.#reveal.begin(viewer)
        this.#loop.wake()
      })
  }

  #advance(delta: number): void {
    this.#face.advance(delta)
    this.#reveal.advance()
    this.#painting.advance()
    this.#sculpting.advance()
    this.#host.orbit?.advance(delta)
    this.#views.show(this.#host.orbit?.view ?? null)
  }

  get #isMoving(): boolean {
    return this.#face.isMoving || this.#reveal.isMoving || (this.#host.orbit?.isMoving ?? false)
  }

  /** Whether the user paints an area, sculpts or edits lines. The face then keeps its pose. */
  get #isEdited(): boolean {
    const isPainted = this.#painting.isOn.value || this.#sculpting.isOn.value
    return isPainted || this.#lines.editor.isEditing.value
  }

  /** Looks at the chosen line or region, or at the mesh with the wrinkles. */
  #frameSelection(weights: GrayImage | null): void {
    const place = this.#lines.placeOf(weights)
    if (place) this.#host.orbit?.lookAt(place.middle, place.radius)
    else this.#face.frameSkin()
    this.#loop.wake()
  }

  #goTo(name: ViewName): void {
    this.#host.orbit?.goTo(name)
    this.#loop.wake()
  }

  /** Hides muted areas. @param isWhole whether to show wrinkles on both sides of the divider. */
  #arrange(viewer: Viewer | null, hidden: readonly string[], isWhole: boolean): void {
    if (!viewer) return
    viewer.hidden = hidden
    viewer.split = isWhole ? 0 : this.#divider.position
    this.#loop.wake()
  }

  #label(): void {
    const viewer = this.#viewer
    if (!viewer) return
    this.#page.sideWith.textContent = lookLabel(viewer.look, viewer.mode)
    this.#page.backend.textContent = viewer.stage.backend
    this.#page.adapter.textContent = adapterName(viewer.stage.renderer)
    this.#page.adapter.title = this.#page.adapter.textContent
  }
}
