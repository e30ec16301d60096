import type { BufferGeometry, Camera, Mesh } from 'three'
import { smoothstep } from '../../math/scalar.ts'
import type { Face } from '../../runtime/face.ts'
import type { AreaArray } from '../atlas/area-array.ts'
import { pixelsPerUnit } from '../camera/size-on-screen.ts'
import type { ReliefMode } from '../options.ts'
import type { AnyRenderer } from '../renderer.ts'
import { limitationOf } from './limitation.ts'
import { type MeshUnits, meshUnits } from './mesh-units.ts'
import type { RaisedFace } from './raised-face.ts'
import { canRise } from './raised-layer.ts'
import { Relief, type ReliefHost } from './relief.ts'
import type { ReliefParts } from './relief-parts.ts'

/** Pixels per millimetre at which relief by size begins, and at which it is full: between them it grows, so that nobody sees it come. */
const SIZES = [1, 1.5] as const

/** Activation up to which relief by size grows with the face's largest one: a face at rest is drawn as without relief. */
const AWAKE = 0.1

/** Draws in a row in which nothing of it is seen before the meshes themselves are drawn again: cameras may take turns. */
const PATIENCE = 60

/** Creates the relief of a face by a renderer's shaders. */
export type CreateRelief = (face: RaisedFace, mode: ReliefMode) => ReliefControl

/** Whether a face is drawn with relief: splits its meshes when that is first wanted, and shows it while it can be seen. */
export class ReliefControl {
  #mode: ReliefMode
  readonly #face: RaisedFace
  readonly #parts: ReliefParts
  readonly #units: MeshUnits
  #relief: Relief | null = null
  #making: Promise<void> | null = null
  /** The areas that the meshes were split under: they are split again under others. */
  #areas: AreaArray | null = null
  #version = 0
  /** The geometries that were split: a page may give a mesh another one. */
  #geometries: BufferGeometry[] = []
  /** Whether the dense geometries are drawn. */
  isShown = false
  #isPossible: boolean
  #isDisposed = false
  /** What keeps the relief from being drawn, or as fine as it should be, though nothing is wrong with the file. */
  #limitation: Error | null = null
  /** Draws in a row in which nothing of it was seen. */
  #unseen = 0

  constructor(face: RaisedFace, parts: ReliefParts, mode: ReliefMode) {
    this.#face = face
    this.#parts = parts
    this.#units = meshUnits(face.mesh, face.place)
    this.#isPossible = face.shaderInputs.textures.layers.some(canRise)
    this.#mode = mode
  }

  get mode(): ReliefMode {
    return this.#mode
  }

  set mode(mode: ReliefMode) {
    this.#mode = mode
    this.#tellLimitation()
    // By size the next frame tells.
    if (mode !== 'near') this.#show(mode === 'on')
  }

  /** Splits the meshes, and shows the relief if the mode is `on`. */
  async ready(): Promise<void> {
    await this.#make()
    if (this.mode === 'on') this.#show(true)
  }

  /** Called when the material shows another mode, so that the first frame has its relief already. */
  resume(): void {
    if (this.#relief && !this.#isOutdated && this.#amountAt(this.#relief.pixelsPerMetre) > 0) this.#show(true)
  }

  /** Called before a mesh is drawn. */
  prepare(renderer: AnyRenderer, camera: Camera, mesh: Mesh): void {
    if (!this.#isPossible || (this.mode === 'off' && !this.#relief)) return
    const pixelsPerMetre = pixelsPerUnit(mesh, camera, renderer) / this.#units.atRest
    const amount = this.#amountAt(pixelsPerMetre)
    if (this.#relief) {
      this.#relief.amount.value = amount
      this.#relief.pixelsPerMetre = pixelsPerMetre
      this.#relief.follow()
    }
    if (amount === 0) {
      this.#unseen++
      if (this.isShown && this.#unseen === PATIENCE) queueMicrotask(() => this.#show(false))
      return
    }
    this.#unseen = 0
    if (!this.isShown || this.#isOutdated) this.#begin()
  }

  /** Frees the relief. A later frame makes it again. Not to be called during a frame. */
  suspend(): void {
    this.#drop()
    this.#geometries = []
  }

  dispose(): void {
    this.#isDisposed = true
    this.#relief?.dispose()
    this.#relief = null
  }

  get #isOutdated(): boolean {
    const { meshes, shaderInputs } = this.#face
    const { areas } = shaderInputs
    if (areas !== this.#areas || areas.version !== this.#version) return true
    return meshes.some(({ geometry }, i) => geometry !== this.#geometries[i])
  }

  #amountAt(pixelsPerMetre: number): number {
    if (this.mode === 'off' || this.#face.mode === 'off') return 0
    if (this.mode === 'on') return 1
    const [from, to] = SIZES
    const bySize = smoothstep((pixelsPerMetre / 1000 - from) / (to - from))
    return bySize && bySize * Math.min(largestActivation(this.#face.faces) / AWAKE, 1)
  }

  /** After this frame: lists of what it draws have been made. */
  #begin(): void {
    queueMicrotask(() => this.#make().then(() => this.#show(this.#unseen === 0 && this.mode !== 'off')))
  }

  #show(isShown: boolean): void {
    this.isShown = isShown && this.#relief !== null
    this.#relief?.show(this.isShown)
  }

  #make(): Promise<void> {
    if (!this.#isPossible || !(this.#isOutdated || this.#making)) return Promise.resolve()
    this.#making ??= this.#split().finally(() => {
      this.#making = null
    })
    return this.#making
  }

  async #split(): Promise<void> {
    const { meshes, shaderInputs } = this.#face
    this.#areas = shaderInputs.areas
    this.#version = shaderInputs.areas.version
    this.#geometries = meshes.map(({ geometry }) => geometry)
    const limitation = meshes.map(limitationOf).find(Boolean)
    if (limitation) {
      this.#limit(limitation)
      return
    }
    try {
      const host: ReliefHost = {
        face: this.#face,
        units: this.#units,
        refuse: (error) => this.#limit(error as Error),
      }
      const made = await Relief.create(host, this.#parts, () => !this.#isDisposed)
      if (made) this.#exchange(made)
    } catch (error) {
      this.#end()
      this.#warn(error as Error)
    }
  }

  /** No relief, because of what it cannot do. */
  #limit(limitation: Error): void {
    if (!this.#isPossible) return
    this.#end()
    this.#limitation = limitation
    this.#tellLimitation()
  }

  /** A page that asked for nothing hears of faults only. */
  #tellLimitation(): void {
    if (this.#limitation && this.mode === 'on') this.#warn(this.#limitation)
  }

  /** Once: several faces may have the same heights. */
  #warn(error: Error): void {
    if (told.has(error)) return
    told.add(error)
    console.warn(
      this.#isPossible ? error.message : `${error.message} (the wrinkles are shown without relief)`,
    )
  }

  /** The face stays without relief from the next frame on. */
  #end(): void {
    this.#isPossible = false
    queueMicrotask(() => {
      if (!this.#isDisposed) this.#drop()
    })
  }

  #drop(): void {
    this.#show(false)
    if (this.#relief) this.#face.material.setRelief(null)
    this.#relief?.dispose()
    this.#relief = null
  }

  #exchange(made: Relief): void {
    const before = this.#relief
    made.amount.value = before?.amount.value ?? Number(this.mode === 'on')
    this.#relief = made
    this.#limitation = made.limitation
    this.#tellLimitation()
    this.#face.material.setRelief((own) => made.patch(own))
    before?.dispose()
    this.#show(this.isShown)
  }
}

/** Of all areas of all faces. */
function largestActivation(faces: readonly Face[]): number {
  let largest = 0
  for (const { activations, slots } of faces) {
    const { values } = activations
    for (let i = 0; i < slots.slots.length; i++) largest = Math.max(largest, values[i])
  }
  return largest
}

const told = new WeakSet<Error>()
