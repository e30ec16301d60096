import { EXPRESSIONS } from 'furrow'
import type { WrinkleMode } from 'furrow/three'
import type { RendererKind } from '../../../stage/stage.ts'
import { displayName } from '../display-name.ts'
import type { Page } from '../page.ts'
import type { Dial } from '../viewer/dials.ts'
import type { Look, LookName } from '../viewer/looks.ts'
import type { Viewer } from '../viewer/viewer.ts'
import { AreasPanel } from './areas.ts'
import { Buttons } from './buttons.ts'
import { Choice } from './choice.ts'
import { TargetsPanel } from './targets.ts'

/** What a user can request. */
export interface PanelActions {
  face(name: string): void
  renderer(kind: RendererKind): void
  mode(mode: WrinkleMode): void
  look(look: Look): void
  play(expression: string): void
  input(dial: Dial, value: number): void
  reset(dials: readonly Dial[]): void
  addAreas(files: File[]): void
  removeArea(name: string): void
  /** Shows where these areas are on the face, or no longer if there are none. */
  highlight(areas: readonly string[]): void
}

/** The controls beside the stage: they request changes and show the viewer's state. */
export class Panel {
  readonly #page: Page
  readonly #renderers: Choice<RendererKind>
  readonly #modes: Choice<WrinkleMode>
  readonly #looks: Choice<LookName>
  readonly #expressions: Buttons<string>
  readonly #areas: AreasPanel
  readonly #targets: TargetsPanel
  #viewer: Viewer | null = null

  constructor(page: Page, actions: PanelActions) {
    this.#page = page
    page.face.addEventListener('change', () => actions.face(page.face.value))
    this.#renderers = new Choice(page.renderer, actions.renderer)
    this.#modes = new Choice(page.mode, actions.mode)
    this.#looks = new Choice(page.look, () => actions.look(this.#chosenLook()))
    page.area.addEventListener('change', () => actions.look(this.#chosenLook()))
    const names = EXPRESSIONS.map(({ name }) => name)
    this.#expressions = new Buttons(page.expressions, names, actions.play)
    this.#areas = new AreasPanel(page.areas, {
      input: actions.input,
      remove: actions.removeArea,
      hover: (dial) => {
        this.#targets.mark(dial ? (this.#viewer?.driversOf(dial.name) ?? []) : [])
        this.#areas.explain(dial ? (this.#viewer?.explain(dial.name) ?? []) : [])
        actions.highlight(dial ? [dial.name] : [])
      },
    })
    this.#targets = new TargetsPanel(page.targets, page.filter, page.found, actions.input, (dial) => {
      const driven = dial ? (this.#viewer?.drivenBy(dial.name) ?? []) : []
      this.#areas.mark(driven)
      actions.highlight(driven)
    })
    page.resetAreas.addEventListener('click', () => actions.reset(this.#viewer?.areas ?? []))
    page.resetTargets.addEventListener('click', () => actions.reset(this.#viewer?.targets ?? []))
    page.files.addEventListener('change', () => {
      actions.addAreas([...page.files.files!])
      // Otherwise choosing the same file again would not be a change.
      page.files.value = ''
    })
  }

  /** The convention in which added files are painted. */
  get convention(): 'paper' | 'weight' {
    return this.#page.convention.checked ? 'paper' : 'weight'
  }

  /** Sets the list of faces to choose from. */
  setFaces(faces: readonly string[]): void {
    this.#page.face.replaceChildren(...faces.map((name) => new Option(displayName(name), name)))
  }

  /** Shows another viewer, or the same one after its areas have changed. */
  show(viewer: Viewer): void {
    if (this.#viewer !== viewer) this.#targets.show(viewer.targets)
    this.#viewer = viewer
    this.#areas.show(viewer.areas)
    const names = viewer.areas.map(({ name }) => new Option(name, `area:${name}`))
    this.#page.area.replaceChildren(new Option('All areas, as activated', 'all'), ...names)
    this.refresh()
  }

  /** Updates the settings to the viewer's state. */
  refresh(): void {
    if (!this.#viewer) return
    const { kind, avatar, mode, look } = this.#viewer
    this.#renderers.show(kind)
    this.#showFace(avatar.name)
    this.#modes.show(mode)
    this.#looks.show(look.name)
    this.#page.areaRow.hidden = look.name !== 'influence'
    this.#page.area.value =
      look.name === 'influence' && typeof look.area === 'string' ? `area:${look.area}` : 'all'
  }

  /** A face that was dropped is in the list only while it is shown. */
  #showFace(name: string): void {
    const { face } = this.#page
    for (const option of [...face.options])
      if (option.dataset.dropped && option.value !== name) option.remove()
    if (![...face.options].some(({ value }) => value === name)) {
      const option = new Option(displayName(name), name)
      option.dataset.dropped = 'true'
      face.append(option)
    }
    face.value = name
  }

  /** Marks the expression that the face shows or moves to; null once a slider has changed it. */
  showExpression(name: string | null): void {
    this.#expressions.show(name)
  }

  /** Updates the sliders to the face. */
  follow(): void {
    this.#areas.follow()
    this.#targets.follow()
  }

  #chosenLook(): Look {
    const name = this.#looks.value
    if (name !== 'influence') return { name }
    const area = this.#page.area.value
    return area.startsWith('area:') ? { name, area: area.slice('area:'.length) } : { name }
  }
}
