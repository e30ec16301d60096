import { EXPRESSIONS } from 'furrow'
import type { WrinkleMode } from 'furrow/three'
import type { RendererKind } from '../../../stage/stage.ts'
import type { Dial } from '../dials.ts'
import type { Look, LookName } from '../looks.ts'
import type { Page } from '../page.ts'
import type { Viewer } from '../viewer.ts'
import { spoken } from '../words.ts'
import { AreasPanel } from './areas.ts'
import { Buttons } from './buttons.ts'
import { Choice } from './choice.ts'
import { TargetsPanel } from './targets.ts'

/** What a user can ask for. */
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
  /** Areas that shall light up on the face; none any more. */
  light(areas: readonly string[]): void
}

/** The controls beside the stage: they ask, and they show what is. */
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
      point: (dial) => {
        this.#targets.mark(dial ? (this.#viewer?.driversOf(dial.name) ?? []) : [])
        this.#areas.explain(dial ? (this.#viewer?.explain(dial.name) ?? []) : [])
        actions.light(dial ? [dial.name] : [])
      },
    })
    this.#targets = new TargetsPanel(page.targets, page.filter, page.found, actions.input, (dial) => {
      const driven = dial ? (this.#viewer?.drivenBy(dial.name) ?? []) : []
      this.#areas.mark(driven)
      actions.light(driven)
    })
    page.resetAreas.addEventListener('click', () => actions.reset(this.#viewer?.areas ?? []))
    page.resetTargets.addEventListener('click', () => actions.reset(this.#viewer?.targets ?? []))
    page.files.addEventListener('change', () => {
      actions.addAreas([...page.files.files!])
      // The same file again is a change too.
      page.files.value = ''
    })
  }

  /** How a file that is added was painted. */
  get convention(): 'paper' | 'weight' {
    return this.#page.convention.checked ? 'paper' : 'weight'
  }

  /** Shows which faces there are. */
  offer(faces: readonly string[]): void {
    this.#page.face.replaceChildren(...faces.map((name) => new Option(spoken(name), name)))
  }

  /** Shows another viewer, or the same one with other areas. */
  show(viewer: Viewer): void {
    if (this.#viewer !== viewer) this.#targets.show(viewer.targets)
    this.#viewer = viewer
    this.#areas.show(viewer.areas)
    const names = viewer.areas.map(({ name }) => new Option(name, `area:${name}`))
    this.#page.area.replaceChildren(new Option('All areas, as they stand', 'all'), ...names)
    this.refresh()
  }

  /** Shows what is chosen, as far as it may have changed by itself. */
  refresh(): void {
    if (!this.#viewer) return
    const { kind, loaded, mode, look } = this.#viewer
    this.#renderers.show(kind)
    this.#page.face.value = loaded.name
    this.#modes.show(mode)
    this.#looks.show(look.name)
    this.#page.areaRow.hidden = look.name !== 'influence'
    this.#page.area.value =
      look.name === 'influence' && typeof look.area === 'string' ? `area:${look.area}` : 'all'
  }

  /** Shows which expression the face has or heads for; null when sliders made it another. */
  showExpression(name: string | null): void {
    this.#expressions.show(name)
  }

  /** Lets the sliders follow the face. */
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
