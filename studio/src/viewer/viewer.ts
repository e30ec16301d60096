import {
  type Area,
  type ArraySlice,
  driversOf,
  type Expression,
  FurrowError,
  type GrayImage,
  type Layer,
  type WrinkleDriver,
} from 'furrow'
import type { Skin } from 'furrow/author'
import { BENT, DEFAULT_AREA_SIZE } from 'furrow/internal'
import { addArea, removeArea, type WrinkleMode } from 'furrow/three'
import type { Mesh, Object3D } from 'three'
import type { Face } from '../../../stage/face.ts'
import type { RendererKind, Stage, Wrinkles } from '../../../stage/stage.ts'
import { AREA_SIZES } from '../document/area-size.ts'
import { faceOf, type OpenedAvatar } from '../open/avatar.ts'
import { releaseFromGPU } from '../open/release.ts'
import { jointSkin } from '../open/skin-source.ts'
import type { CanvasStage } from './canvas-stage.ts'
import type { Look } from './looks/look.ts'
import { Looks } from './looks/looks.ts'
import { Sides } from './looks/sides.ts'
import { type BodyPose, bodyPoses, jointsOfArea } from './pose/body-poses.ts'
import { areaDials, type Dial, targetDials } from './pose/dials.ts'
import { DrivenAreas } from './pose/driven-areas.ts'
import { FaceExpressions } from './pose/face-expressions.ts'
import { MuscleTargets } from './pose/muscle-targets.ts'
import {
  expressionsShowing,
  type Performance,
  performanceOf,
  type ShowingExpression,
} from './pose/performance.ts'
import { SkeletonPose } from './pose/skeleton-pose.ts'

/** Draws one avatar on a canvas. A vertical divider separates the plain face (left) from the face with wrinkles (right). */
export class Viewer {
  readonly canvas: HTMLCanvasElement
  readonly kind: RendererKind
  readonly stage: Stage
  readonly avatar: OpenedAvatar
  /** All meshes of the avatar. */
  readonly meshes: readonly Mesh[]
  targets: readonly Dial[] = []
  areas: readonly Dial[] = []
  /** Amounts of the poses of joints. */
  poses: readonly Dial[] = []
  readonly skeleton: SkeletonPose
  /** Position of the divider, as a fraction of the canvas's width. */
  split = 0.5
  /** Names of the areas that are drawn as if inactive. */
  hidden: readonly string[] = []
  readonly driven = new DrivenAreas()
  /** Onset maps that are images, not slices of KTX 2 files. The keys are names of layers. */
  onsets: ReadonlyMap<string, GrayImage> = new Map()

  readonly #face: Face
  /** The skin's material without wrinkles, cloned for each `Looks`. */
  readonly #plain: Mesh['material']
  #wrinkles: Wrinkles | null = null
  #error: Error | null = null
  readonly #muscles: MuscleTargets
  readonly #expressions: FaceExpressions
  /** Skin with its joints, read when drivers need them. */
  #jointSkin: Skin | null | undefined
  /** Weights of the areas, to find the areas on the skin. */
  readonly #weights = new Map<string, Area<ArraySlice>['weights']>()
  #looks!: Looks
  #mode: WrinkleMode = 'default'
  #look: Look = { name: 'shaded' }
  #highlighted: readonly string[] = []
  readonly #sides: Sides

  /** If the avatar's wrinkles do not fit the face, omits them and sets `error`. */
  constructor({ canvas, kind, stage }: CanvasStage, avatar: OpenedAvatar) {
    this.canvas = canvas
    this.kind = kind
    this.stage = stage
    this.avatar = avatar
    this.#sides = new Sides(canvas, stage)
    const face = faceOf(avatar)
    this.#face = face
    this.meshes = meshesOf(face.root)
    this.#plain = cloned(face.skin.material)
    this.#expressions = new FaceExpressions(avatar.root, avatar.expressions)
    this.skeleton = new SkeletonPose(avatar.root, avatar.rest)
    stage.show(face)
    this.#muscles = new MuscleTargets([face.skin, ...face.parts])
    this.#addWrinkles(face.wrinkles)
  }

  /** Wrinkles of the face, or null if it has none. */
  get wrinkles(): Wrinkles | null {
    return this.#wrinkles
  }

  /** Reason why the avatar's wrinkles are not shown, or null. */
  get error(): Error | null {
    return this.#error
  }

  /**
   * Replaces the wrinkles of the face, or removes them. Keeps the mode, the look and activations set by hand.
   *
   * @throws FurrowError if the wrinkles do not fit the face. The face then has no wrinkles.
   */
  setWrinkles(wrinkles: Face['wrinkles']): void {
    const before = new Map(this.areas.map(({ name, read }) => [name, read()]))
    const { mode, look } = this
    this.#looks.dispose()
    this.#wrinkles?.dispose()
    this.#addWrinkles(wrinkles)
    for (const { name, read, write } of this.areas) write(before.get(name) ?? read())
    this.driven.drive()
    if (this.#error) throw this.#error
    this.mode = mode
    this.look = this.#isPossible(look) ? look : { name: 'shaded' }
  }

  setDrivers(drivers: readonly WrinkleDriver[]): void {
    this.#addMuscles(drivers)
    this.driven.setDrivers(drivers)
    this.#rebuildExpressions()
  }

  /** Adds wrinkles to the face, which must have none. */
  #addWrinkles(wrinkles: Face['wrinkles']): void {
    this.#error = null
    this.#wrinkles = null
    this.#addMuscles(wrinkles?.drivers ?? [])
    try {
      // Disable relief, because it draws another mesh instead of the skin. Looks, lines and brushes work only on the skin.
      const options = { relief: 'off', areaSize: areaSizeOf(wrinkles?.set.areas ?? []) } as const
      if (wrinkles) this.#wrinkles = this.stage.addWrinkles(this.#face, wrinkles, options)
    } catch (error) {
      this.#error = error as Error
    }
    this.driven.attach(this.#wrinkles, wrinkles?.set.areas ?? [], wrinkles?.drivers ?? [])
    this.#weights.clear()
    for (const { name, weights } of wrinkles?.set.areas ?? []) this.#weights.set(name, weights)
    this.onsets = onsetsOf(wrinkles?.set.layers ?? [])
    const createMirror = (mesh: Mesh, own: Wrinkles) => this.stage.mirror(mesh, own)
    this.#looks = new Looks(this.#face, this.#wrinkles, cloned(this.#plain), createMirror, this.onsets)
    this.#rebuildAreas()
    this.driven.drive()
  }

  /** Adds a blendshape for each muscle, and makes a `Dial` (a number that a slider controls) for each blendshape. */
  #addMuscles(drivers: readonly WrinkleDriver[]): void {
    this.#muscles.update(driversOf('muscle', drivers))
    this.targets = targetDials(this.#face.root).map((dial) => ({
      ...dial,
      write: (value) => this.driven.applyChange(() => dial.write(value)),
    }))
  }

  #isPossible(look: Look): boolean {
    if (look.name === 'onset') return look.layer === undefined || this.onsets.has(look.layer)
    if (look.name !== 'influence' || look.area === undefined) return true
    return [look.area].flat().every((name) => this.#wrinkles?.hasArea(name))
  }

  get mode(): WrinkleMode {
    return this.#mode
  }

  /** @throws FurrowError if this face does not support the mode. The mode then does not change. */
  set mode(mode: WrinkleMode) {
    if (this.wrinkles) this.wrinkles.mode = mode
    this.#mode = mode
    this.look = this.#look
  }

  get look(): Look {
    return this.#look
  }

  /** Shows onset maps that were changed in place, if the look is `onset`. */
  refreshOnset(): void {
    if (this.#look.name === 'onset') this.#choose(this.#look)
  }

  set look(look: Look) {
    this.#choose(look)
    this.#look = look
  }

  /** Applies a look, or shows the highlighted areas if there are any. */
  #choose(look: Look): void {
    const area = this.#highlighted.filter((name) => this.#wrinkles?.hasArea(name))
    this.#looks.choose(area.length > 0 ? { name: 'marked', area } : look)
  }

  /** Shows where areas are, regardless of their activations. An empty list restores the chosen look. */
  highlight(areas: readonly string[]): void {
    this.#highlighted = areas
    this.#choose(this.#look)
  }

  /** Returns a pose that shows an area, or null if no expression or blendshape activates the area. */
  performanceOf(area: string): Performance | null {
    const names = this.targets.map(({ name }) => name)
    const { list } = this.driven.drivers
    return performanceOf(area, list, this.#expressions.list, names) ?? this.#foldingOf(area)
  }

  /** Returns a pose of joints that folds an area. The face stays as it is. */
  #foldingOf(area: string): Performance | null {
    const skin = this.#skinWithJoints()
    if (!skin) return null
    const turns = jointsOfArea(skin, this.driven.drivers.list, area, BENT)
    if (turns.size === 0) return null
    const targets = new Map(this.targets.map(({ name, read }) => [name, read()]))
    return { targets, activations: new Map(), joints: this.skeleton.turned(turns) }
  }

  /** Returns the skin if drivers read its joints. */
  #skinWithJoints(): Skin | null {
    if (driversOf('bone', this.driven.drivers.list).length === 0) return null
    this.#jointSkin ??= jointSkin(this.avatar)
    return this.#jointSkin
  }

  /** Returns the poses of joints that fold an area. */
  posesShowing(area: string): readonly BodyPose[] {
    return this.skeleton.poses.filter(({ areas }) => areas.includes(area))
  }

  /** Returns the expressions that show an area, the strongest first. */
  expressionsShowing(area: string): readonly ShowingExpression[] {
    const names = this.targets.map(({ name }) => name)
    return expressionsShowing(area, this.driven.drivers.list, this.#expressions.list, names)
  }

  get expressions(): readonly Expression[] {
    return this.#expressions.list
  }

  /** Whether a transition to an expression or a pose of joints is running. */
  get isMoving(): boolean {
    return this.#expressions.isMoving || this.skeleton.isMoving
  }

  /** Starts a transition to an expression from the current state. */
  play(name: string, seconds: number): void {
    this.#moveFace(() => this.#expressions.play(name, seconds))
  }

  /** Starts a transition to a pose of joints from the current one. @param name name of a pose, or `REST_POSE`. */
  playPose(name: string, seconds: number): void {
    this.move(() => this.skeleton.play(name, seconds))
  }

  /** @param delta seconds since the last frame; infinity ends the transition. */
  advance(delta: number): void {
    if (this.#expressions.isMoving) this.#moveFace(() => this.#expressions.advance(delta))
    if (this.skeleton.isMoving) this.move(() => this.skeleton.advance(delta))
  }

  /** Runs a function that moves joints and blendshapes directly. Then updates the driven areas. */
  move(change: () => void): void {
    this.driven.applyChange(() => {
      change()
      // Drivers that read joints need current world matrices.
      this.avatar.root.updateMatrixWorld()
    })
  }

  /** @throws FurrowError if the area cannot be added. The face then does not change. */
  addArea(area: Area): void {
    if (!this.wrinkles) throw noWrinklesError(area.name)
    addArea(this.wrinkles, area)
    this.#face.wrinkles?.set.areas.push(area)
    this.driven.resting.set(area.name, area.activation ?? 0)
    this.#weights.set(area.name, area.weights)
    this.#areasChanged()
  }

  /** @throws FurrowError if the area is the last one. */
  removeArea(name: string): void {
    if (!this.wrinkles) return
    removeArea(this.wrinkles, name)
    this.#weights.delete(name)
    const set = this.#face.wrinkles?.set
    if (set) set.areas = set.areas.filter((area) => area.name !== name)
    const isShown = this.#look.name === 'influence' && this.#look.area === name
    if (isShown) this.#look = { name: 'influence' }
    this.#areasChanged()
  }

  draw(): void {
    if (!this.isMoving) this.#looks.follow()
    const hidden = this.areas.filter(({ name }) => this.hidden.includes(name))
    const activations = hidden.map(({ read }) => read())
    for (const { write } of hidden) write(0)
    this.#sides.draw(this.#looks, this.split)
    for (const [i, { write }] of hidden.entries()) write(activations[i])
  }

  /** Frees GPU resources. The avatar and the stage can be used by other viewers. */
  dispose(): void {
    this.#looks.dispose()
    this.wrinkles?.dispose()
    this.stage.scene.remove(this.avatar.root)
    this.#sides.dispose()
    releaseFromGPU(this.avatar.root)
  }

  /** Runs a function that moves the face by an expression. Then updates the driven areas, except areas that expressions set. */
  #moveFace(play: () => void): void {
    this.driven.applyChange(play, (area) => !this.#expressions.setsArea(area))
  }

  #areasChanged(): void {
    this.#rebuildAreas()
    this.look = this.#look
  }

  #rebuildAreas(): void {
    this.areas = this.#wrinkles ? areaDials(this.#wrinkles) : []
    this.#rebuildExpressions()
    this.#expressions.stop()
  }

  #rebuildExpressions(): void {
    const names = (dials: readonly Dial[]) => dials.map(({ name }) => name)
    this.#expressions.rebuild(this.driven.drivers, this.wrinkles, names(this.targets), names(this.areas))
    const skin = this.#skinWithJoints()
    this.skeleton.poses = skin ? bodyPoses(skin, this.driven.drivers.list, this.#weights) : []
    this.poses = this.skeleton.poses.map(({ name }) => ({
      name,
      read: () => this.skeleton.amountOf(name),
      write: (amount) => this.move(() => this.skeleton.setAmount(name, amount)),
    }))
  }
}

function cloned(material: Mesh['material']): Mesh['material'] {
  return Array.isArray(material) ? material.map((each) => each.clone()) : material.clone()
}

function meshesOf(root: Object3D): Mesh[] {
  const meshes: Mesh[] = []
  root.traverse((object) => {
    if ((object as Mesh).isMesh) meshes.push(object as Mesh)
  })
  return meshes
}

function onsetsOf(layers: readonly Layer<ArraySlice>[]): ReadonlyMap<string, GrayImage> {
  return new Map(
    layers.flatMap(({ name, onset }): [string, GrayImage][] =>
      onset && 'data' in onset ? [[name, onset]] : [],
    ),
  )
}

/** Returns the size at which the stage shows areas, texels: that of the largest area, from 128 to 512. */
function areaSizeOf(areas: readonly Area<ArraySlice>[]): number {
  const sizes = areas.map(({ weights }) => ('data' in weights ? weights.width : 0))
  return Math.min(AREA_SIZES.at(-1)!, Math.max(DEFAULT_AREA_SIZE, ...sizes))
}

function noWrinklesError(area: string): FurrowError {
  return new FurrowError({
    who: 'Studio',
    problem: 'the face has no wrinkles, so no area can be added',
    value: area,
    remedy: 'first drop an avatar with wrinkles, or a folder with wrinkles',
  })
}
