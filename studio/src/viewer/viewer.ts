import { type Area, driversOf, FurrowError, type WrinkleDriver } from 'furrow'
import { addArea, removeArea, Wrinkles as WebGLWrinkles, type WrinkleMode } from 'furrow/three'
import { Wrinkles as WebGPUWrinkles } from 'furrow/webgpu'
import type { Mesh } from 'three'
import type { Face } from '../../../stage/face.ts'
import { isWebGL } from '../../../stage/light.ts'
import type { RendererKind, Stage, Wrinkles } from '../../../stage/stage.ts'
import { faceOf, type OpenedAvatar } from '../open/avatar.ts'
import { releaseFromGPU } from '../open/release.ts'
import type { CanvasStage } from './canvas-stage.ts'
import { type Look, Looks } from './looks/looks.ts'
import { Sides } from './looks/sides.ts'
import { areaDials, type Dial, targetDials } from './pose/dials.ts'
import { DrivenAreas } from './pose/driven-areas.ts'
import { FaceExpressions } from './pose/face-expressions.ts'
import { MuscleTargets } from './pose/muscle-targets.ts'
import { type Performance, performanceOf } from './pose/performance.ts'

/** One avatar on one renderer's canvas, drawn without wrinkles left of the divider and with them right of it. */
export class Viewer {
  readonly canvas: HTMLCanvasElement
  readonly kind: RendererKind
  readonly stage: Stage
  readonly avatar: OpenedAvatar
  targets: readonly Dial[] = []
  areas: readonly Dial[] = []
  /** Fraction of the width that is drawn without wrinkles. */
  split = 0.5
  /** Areas that are drawn as if they were not active. */
  hidden: readonly string[] = []
  readonly driven = new DrivenAreas()

  readonly #face: Face
  /** The skin's material as it was before wrinkles were added; cloned for each `Looks`. */
  readonly #plain: Mesh['material']
  #wrinkles: Wrinkles | null = null
  #fault: Error | null = null
  readonly #muscles: MuscleTargets
  readonly #expressions: FaceExpressions
  #looks!: Looks
  #mode: WrinkleMode = 'default'
  #look: Look = { name: 'shaded' }
  #highlighted: readonly string[] = []
  readonly #sides: Sides

  /** Wrinkles that do not fit the face are left out. */
  constructor({ canvas, kind, stage }: CanvasStage, avatar: OpenedAvatar) {
    this.canvas = canvas
    this.kind = kind
    this.stage = stage
    this.avatar = avatar
    this.#sides = new Sides(canvas, stage)
    const face = faceOf(avatar)
    this.#face = face
    this.#plain = cloned(face.skin.material)
    this.#expressions = new FaceExpressions(avatar.root, avatar.expressions)
    stage.show(face)
    this.#muscles = new MuscleTargets([face.skin, ...face.parts])
    this.#wear(face.wrinkles)
  }

  /** Null for a plain face. */
  get wrinkles(): Wrinkles | null {
    return this.#wrinkles
  }

  /** Why the wrinkles of the avatar are not shown; null if they are, or there are none. */
  get fault(): Error | null {
    return this.#fault
  }

  /**
   * Shows other wrinkles on the same face, null for none. The mode and the look stay, and so do activations that were set by hand.
   *
   * @throws FurrowError when they do not fit; the face is then plain.
   */
  setWrinkles(wrinkles: Face['wrinkles']): void {
    const before = new Map(this.areas.map(({ name, read }) => [name, read()]))
    const { mode, look } = this
    this.#looks.dispose()
    this.#wrinkles?.dispose()
    this.#wear(wrinkles)
    for (const { name, read, write } of this.areas) write(before.get(name) ?? read())
    this.driven.drive()
    if (this.#fault) throw this.#fault
    this.mode = mode
    this.look = this.#isPossible(look) ? look : { name: 'shaded' }
  }

  /** Lets other drivers activate the areas. */
  setDrivers(drivers: readonly WrinkleDriver[]): void {
    this.#addMuscles(drivers)
    this.driven.setDrivers(drivers)
    this.#renewExpressions()
  }

  /** Puts wrinkles on the plain face. */
  #wear(wrinkles: Face['wrinkles']): void {
    this.#fault = null
    this.#wrinkles = null
    this.#addMuscles(wrinkles?.drivers ?? [])
    try {
      // Relief is drawn by a mesh of its own, which looks, lines and brushes do not know.
      if (wrinkles) this.#wrinkles = this.stage.addWrinkles(this.#face, wrinkles, { relief: 'off' })
    } catch (error) {
      this.#fault = error as Error
    }
    this.driven.wear(this.#wrinkles, wrinkles?.set.areas ?? [], wrinkles?.drivers ?? [])
    const plain = cloned(this.#plain)
    this.#looks = new Looks(this.#face, this.#wrinkles, plain, (mesh, own) => this.#createMirror(mesh, own))
    this.#renewAreas()
    this.driven.drive()
  }

  /** Each muscle is a blendshape more. */
  #addMuscles(drivers: readonly WrinkleDriver[]): void {
    this.#muscles.update(driversOf('muscle', drivers))
    this.targets = targetDials(this.#face.root).map((dial) => ({
      ...dial,
      write: (value) => this.driven.driveAfter(() => dial.write(value)),
    }))
  }

  #isPossible(look: Look): boolean {
    if (look.name !== 'influence' || look.area === undefined) return true
    return [look.area].flat().every((name) => this.#wrinkles?.hasArea(name))
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
    this.#choose(look)
    this.#look = look
  }

  /** Highlighted areas come before a look. */
  #choose(look: Look): void {
    const area = this.#highlighted.filter((name) => this.#wrinkles?.hasArea(name))
    this.#looks.choose(area.length > 0 ? { name: 'marked', area } : look)
  }

  /** Shows where areas are on the face, whatever their activations; of an empty list, restores the chosen look. */
  highlight(areas: readonly string[]): void {
    this.#highlighted = areas
    this.#choose(this.#look)
  }

  /** The pose that shows an area; null where no blendshape does. */
  performanceOf(area: string): Performance | null {
    const names = this.targets.map(({ name }) => name)
    return performanceOf(area, this.driven.drivers.list, this.#expressions.list, names)
  }

  get expressionNames(): string[] {
    return this.#expressions.list.map(({ name }) => name)
  }

  /** Whether a transition to an expression is under way. */
  get moving(): boolean {
    return this.#expressions.moving
  }

  /** Starts a transition to an expression from the current state. */
  play(name: string, seconds: number): void {
    this.#moveFace(() => this.#expressions.play(name, seconds))
  }

  /** @param delta seconds since the last frame; infinity ends the transition. */
  advance(delta: number): void {
    if (this.moving) this.#moveFace(() => this.#expressions.advance(delta))
  }

  /** Moves joints and blendshapes by other means than the dials; areas follow all the same. */
  move(change: () => void): void {
    this.driven.driveAfter(() => {
      change()
      // Joints are read from it.
      this.avatar.root.updateMatrixWorld()
    })
  }

  /** @throws FurrowError if the area cannot be added; nothing changes then. */
  addArea(area: Area): void {
    if (!this.wrinkles) throw withoutLayers(area.name)
    addArea(this.wrinkles, area)
    this.#face.wrinkles?.set.areas.push(area)
    this.driven.resting.set(area.name, area.activation ?? 0)
    this.#areasChanged()
  }

  /** @throws FurrowError if the area is the last one. */
  removeArea(name: string): void {
    if (!this.wrinkles) return
    removeArea(this.wrinkles, name)
    const set = this.#face.wrinkles?.set
    if (set) set.areas = set.areas.filter((area) => area.name !== name)
    const isShown = this.#look.name === 'influence' && this.#look.area === name
    if (isShown) this.#look = { name: 'influence' }
    this.#areasChanged()
  }

  draw(): void {
    if (!this.moving) this.#looks.follow()
    const hidden = this.areas.filter(({ name }) => this.hidden.includes(name))
    const activations = hidden.map(({ read }) => read())
    for (const { write } of hidden) write(0)
    this.#sides.draw(this.#looks, this.split)
    for (const [i, { write }] of hidden.entries()) write(activations[i])
  }

  /** Frees what the avatar has on the GPU; it remains usable by another viewer, and the stage for another avatar. */
  dispose(): void {
    this.#looks.dispose()
    this.wrinkles?.dispose()
    this.stage.scene.remove(this.avatar.root)
    this.#sides.dispose()
    releaseFromGPU(this.avatar.root)
  }

  /** Plays an expression: areas that expressions name are played, the others follow the face. */
  #moveFace(play: () => void): void {
    this.driven.driveAfter(play, (area) => !this.#expressions.sets(area))
  }

  #areasChanged(): void {
    this.#renewAreas()
    this.look = this.#look
  }

  #renewAreas(): void {
    this.areas = this.#wrinkles ? areaDials(this.#wrinkles) : []
    this.#renewExpressions()
    this.#expressions.stop()
  }

  #renewExpressions(): void {
    const names = (dials: readonly Dial[]) => dials.map(({ name }) => name)
    this.#expressions.renew(this.driven.drivers, this.wrinkles, names(this.targets), names(this.areas))
  }

  #createMirror(mesh: Mesh, wrinkles: Wrinkles): Wrinkles {
    return isWebGL(this.stage.renderer)
      ? new WebGLWrinkles(mesh, wrinkles)
      : new WebGPUWrinkles(mesh, wrinkles)
  }
}

function cloned(material: Mesh['material']): Mesh['material'] {
  return Array.isArray(material) ? material.map((each) => each.clone()) : material.clone()
}

function withoutLayers(area: string): FurrowError {
  return new FurrowError({
    who: 'Studio',
    problem: 'the face has no wrinkles for an area to show',
    value: area,
    remedy: 'drop an avatar with wrinkles, or a folder of wrinkles, first',
  })
}
