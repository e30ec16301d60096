import {
  type Area,
  canonicalTargetName,
  DriverProgram,
  type DriverState,
  driversOf,
  EXPRESSIONS,
  type Expression,
  explain,
  FurrowError,
  planDrivers,
  targetSource,
  type WrinkleDriver,
} from 'furrow'
import { ExpressionPlayer, Wrinkles as WebGLWrinkles, type WrinkleMode } from 'furrow/three'
import { Wrinkles as WebGPUWrinkles } from 'furrow/webgpu'
import { type Color, type Mesh, NoToneMapping } from 'three'
import type { Face } from '../../../stage/face.ts'
import { isWebGL } from '../../../stage/light.ts'
import type { RendererKind, Stage, Wrinkles } from '../../../stage/stage.ts'
import { faceOf, type OpenedAvatar } from '../open/avatar.ts'
import type { CanvasStage } from './canvas-stage.ts'
import { areaDials, type Dial, targetDials } from './dials.ts'
import { type Look, Looks, type Side } from './looks.ts'
import { releaseFromGPU } from './release.ts'

/** One avatar on one renderer's canvas, drawn without wrinkles left of the divider and with them right of it. */
export class Viewer {
  readonly canvas: HTMLCanvasElement
  readonly kind: RendererKind
  readonly stage: Stage
  readonly avatar: OpenedAvatar
  /** Null for a plain face. */
  readonly wrinkles: Wrinkles | null
  /** Why the wrinkles of the avatar are not shown; null if they are, or there are none. */
  readonly fault: Error | null
  readonly targets: readonly Dial[]
  areas: readonly Dial[]
  /** Fraction of the width that is drawn without wrinkles. */
  split = 0.5

  readonly #program: DriverProgram
  readonly #state: DriverState
  readonly #face: Face
  /** Null for a face without blendshapes and wrinkles. */
  #player: ExpressionPlayer | null
  #expressions: readonly Expression[]
  #remaining = 0
  #looks: Looks
  #mode: WrinkleMode = 'default'
  #look: Look = { name: 'shaded' }
  readonly #background: Color
  readonly #toneMapping: Stage['renderer']['toneMapping']

  /** Wrinkles that do not fit the face are left out. */
  constructor({ canvas, kind, stage }: CanvasStage, avatar: OpenedAvatar) {
    this.canvas = canvas
    this.kind = kind
    this.stage = stage
    this.avatar = avatar
    this.#background = (stage.scene.background as Color).clone()
    this.#toneMapping = stage.renderer.toneMapping
    const face = faceOf(avatar)
    this.#face = face
    const plain = plainMaterial(face.skin)
    stage.show(face)
    const { wrinkles, fault } = addWrinkles(stage, face)
    this.wrinkles = wrinkles
    this.fault = fault
    const plan = planDrivers(driversOf('morph', this.#drivers))
    const targetNames = Object.keys(face.skin.morphTargetDictionary ?? {})
    this.#program = new DriverProgram(plan, { target: targetSource(plan.inputs.target, targetNames) })
    this.#state = this.#program.createState()
    this.targets = targetDials(face.root).map((dial) => ({
      ...dial,
      write: (value) => {
        const before = this.#drivenActivations().slice()
        dial.write(value)
        this.#applyDrivers(before)
      },
    }))
    this.areas = wrinkles ? areaDials(wrinkles) : []
    this.#expressions = this.#completeExpressions()
    this.#player = this.#makePlayer()
    this.#looks = new Looks(face, wrinkles, plain, (mesh, own) => this.#createMirror(mesh, own))
  }

  get #drivers(): readonly WrinkleDriver[] {
    return this.#face.wrinkles?.drivers ?? []
  }

  get mode(): WrinkleMode {
    return this.#mode
  }

  /** @throws FurrowError if this face does not support the mode; the mode then does not change. */
  set mode(mode: WrinkleMode) {
    if (this.wrinkles) this.wrinkles.mode = mode
    this.#mode = mode
    this.look = this.#look
  }

  get look(): Look {
    return this.#look
  }

  set look(look: Look) {
    this.#looks.choose(look)
    this.#look = look
  }

  /** Names of the blendshapes that drive an area, as on their dials. */
  driversOf(area: string): string[] {
    return driversOf('morph', this.#drivers)
      .filter((driver) => driver.area === area)
      .flatMap(({ targets }) => targets.map(({ name }) => canonicalTargetName(name)))
  }

  /** Existing areas that a blendshape drives. */
  drivenBy(target: string): string[] {
    const driven = driversOf('morph', this.#drivers).filter(({ targets }) =>
      targets.some(({ name }) => canonicalTargetName(name) === target),
    )
    return [...new Set(driven.map(({ area }) => area))].filter((name) => this.wrinkles?.hasArea(name))
  }

  /** Lines of text: the current activation of an area by each of its drivers, and the part of each input in it. */
  explain(area: string): string[] {
    const { skin } = this.#face
    const situation = {
      targetNames: Object.keys(skin.morphTargetDictionary ?? {}),
      weights: skin.morphTargetInfluences ?? [],
    }
    const [explanation] = explain(this.#drivers, [{ name: area }], situation)
    if (explanation.parts.length === 0) return [`${area} has no driver: only its slider moves it`]
    return explanation.parts.flatMap(({ activation, links }) => [
      `${activation.toFixed(2)} of ${area} from`,
      ...links.map(({ link, value }) => `${value.toFixed(2)} by ${link.name}`),
    ])
  }

  /** Shows where areas are on the face, whatever their activations; of an empty list, restores the chosen look. */
  highlight(areas: readonly string[]): void {
    this.#looks.choose(areas.length > 0 ? { name: 'influence', area: areas } : this.#look)
  }

  /** Whether a transition to an expression is under way. */
  get moving(): boolean {
    return this.#remaining > 0
  }

  /** Starts a transition to an expression from the current state. */
  play(name: string, seconds: number): void {
    if (!this.#player) return
    this.#player.play(name, seconds)
    this.#remaining = seconds
  }

  /** @param delta seconds since the last frame; infinity ends the transition. */
  advance(delta: number): void {
    if (!this.moving) return
    this.#player?.update(delta)
    this.#remaining = Math.max(0, this.#remaining - delta)
  }

  /** @throws FurrowError if the area cannot be added; nothing changes then. */
  addArea(area: Area): void {
    if (!this.wrinkles) throw withoutLayers(area.name)
    this.wrinkles.addArea(area)
    this.#face.wrinkles!.set.areas.push(area)
    this.#areasChanged()
  }

  /** @throws FurrowError if the area is the last one. */
  removeArea(name: string): void {
    if (!this.wrinkles) return
    this.wrinkles.removeArea(name)
    const { set } = this.#face.wrinkles!
    set.areas = set.areas.filter((area) => area.name !== name)
    const isShown = this.#look.name === 'influence' && this.#look.area === name
    if (isShown) this.#look = { name: 'influence' }
    this.#areasChanged()
  }

  draw(): void {
    const { renderer } = this.stage
    const { clientWidth: width, clientHeight: height } = this.canvas
    const edge = Math.round(this.split * width)
    if (edge === 0 || edge === width) {
      renderer.setScissorTest(false)
      this.#drawSide(edge === 0 ? 'with' : 'without')
      return
    }
    renderer.setScissorTest(true)
    renderer.setScissor(0, 0, edge, height)
    this.#drawSide('without')
    renderer.setScissor(edge, 0, width - edge, height)
    this.#drawSide('with')
  }

  /** Frees what the avatar has on the GPU; it remains usable by another viewer, and the stage for another avatar. */
  dispose(): void {
    const { renderer, scene } = this.stage
    this.#looks.dispose()
    this.wrinkles?.dispose()
    scene.remove(this.avatar.root)
    scene.background = this.#background
    renderer.toneMapping = this.#toneMapping
    renderer.setScissorTest(false)
    releaseFromGPU(this.avatar.root)
  }

  #drawSide(side: Side): void {
    const { renderer, scene } = this.stage
    const lit = this.#looks.lit(side)
    this.#looks.apply(side)
    ;(scene.background as Color).copy(lit ? this.#background : this.#looks.technicalBackground)
    // WebGPURenderer tone-maps the whole frame and ignores `toneMapped` of materials.
    if (!isWebGL(renderer)) renderer.toneMapping = lit ? this.#toneMapping : NoToneMapping
    this.stage.render()
  }

  /** Activations that the file's drivers compute from the current blendshape weights. */
  #drivenActivations(): Float32Array {
    this.#state.inputs.target.set(this.#face.skin.morphTargetInfluences ?? [])
    this.#program.evaluate(this.#state)
    return this.#state.activations
  }

  /** After a blendshape was set by hand: sets the areas that it drives and leaves the others. */
  #applyDrivers(before: Float32Array): void {
    const after = this.#drivenActivations()
    for (const [i, name] of this.#program.plan.areaNames.entries()) {
      if (after[i] !== before[i] && this.wrinkles?.hasArea(name)) this.wrinkles.setActivation(name, after[i])
    }
  }

  #areasChanged(): void {
    this.areas = this.wrinkles ? areaDials(this.wrinkles) : []
    this.#expressions = this.#completeExpressions()
    this.#player = this.#makePlayer()
    this.#remaining = 0
    this.look = this.#look
  }

  #makePlayer(): ExpressionPlayer | null {
    if (this.targets.length === 0) return null
    return new ExpressionPlayer(this.avatar.root, this.wrinkles ?? undefined, this.#expressions)
  }

  /** The presets; the first one names every blendshape and area of this face, so that each expression sets all sliders. */
  #completeExpressions(): Expression[] {
    const zeros = (dials: readonly Dial[]) => Object.fromEntries(dials.map(({ name }) => [name, 0]))
    const targets = zeros(this.targets)
    const activations = zeros(this.areas)
    return [{ name: EXPRESSIONS[0].name, targets, activations }, ...EXPRESSIONS.slice(1)]
  }

  #createMirror(mesh: Mesh, wrinkles: Wrinkles): Wrinkles {
    return isWebGL(this.stage.renderer)
      ? new WebGLWrinkles(mesh, wrinkles)
      : new WebGPUWrinkles(mesh, wrinkles)
  }
}

function addWrinkles(stage: Stage, face: Face): { wrinkles: Wrinkles | null; fault: Error | null } {
  if (!face.wrinkles) return { wrinkles: null, fault: null }
  try {
    const wrinkles = stage.addWrinkles(face, face.wrinkles)
    // The viewer runs the drivers, so that the areas' sliders follow at once.
    wrinkles.driven = false
    return { wrinkles, fault: null }
  } catch (error) {
    return { wrinkles: null, fault: error as Error }
  }
}

function plainMaterial({ material }: Mesh): Mesh['material'] {
  return Array.isArray(material) ? material.map((each) => each.clone()) : material.clone()
}

function withoutLayers(area: string): FurrowError {
  return new FurrowError({
    who: 'Studio',
    what: 'the face has no wrinkles for an area to show',
    value: area,
    remedy: 'drop an avatar with wrinkles, or a folder of wrinkles, first',
  })
}
