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
import { hasHeights } from './raised-layer.ts'
import { Relief, type ReliefHost } from './relief.ts'
import type { ReliefParts } from './relief-parts.ts'

/** In the mode `near`, relief begins at the first number of pixels per millimetre of skin, and has full strength at the second. */
const SIZES = [1, 1.5] as const

/** In the mode `near`, relief grows with the largest activation of the face until that activation reaches this value. */
const FULL_ACTIVATION = 0.1

/** Number of consecutive draws without relief before the original meshes are drawn again. Not 1, because a near and a far camera may alternate. */
const MAX_UNSEEN = 60

/** Creates the relief of a face for one kind of renderer. */
export type CreateRelief = (face: RaisedFace, mode: ReliefMode) => ReliefControl

/**
 * Decides when a face is drawn with relief, which displaces its surface by height maps. Relief needs dense geometries, in which the triangles
 * of the meshes are split. The dense geometries are created on first use, and drawn in place of the meshes.
 */
export class ReliefControl {
  #mode: ReliefMode
  readonly #face: RaisedFace
  readonly #parts: ReliefParts
  readonly #units: MeshUnits
  #relief: Relief | null = null
  #making: Promise<void> | null = null
  /** Areas for which the meshes were split. */
  #areas: AreaArray | null = null
  #version = 0
  /** Geometries that were split. The page may replace the geometry of a mesh later. */
  #geometries: BufferGeometry[] = []
  /** Whether the dense geometries are drawn. */
  isShown = false
  #isPossible: boolean
  #isDisposed = false
  /** Reason why a valid mesh has no relief, or has larger triangles than intended. */
  #limitation: Error | null = null
  /** Consecutive draws without visible relief. */
  #unseen = 0

  constructor(face: RaisedFace, parts: ReliefParts, mode: ReliefMode) {
    this.#face = face
    this.#parts = parts
    this.#units = meshUnits(face.mesh, face.place)
    this.#isPossible = face.shaderInputs.textures.layers.some(hasHeights)
    this.#mode = mode
  }

  get mode(): ReliefMode {
    return this.#mode
  }

  set mode(mode: ReliefMode) {
    this.#mode = mode
    this.#warnOfLimitation()
    // In the mode `near`, the next call of `prepare` shows or hides relief.
    if (mode !== 'near') this.#show(mode === 'on')
  }

  /** Creates the dense geometries, and shows relief if the mode is `on`. */
  async ready(): Promise<void> {
    await this.#make()
    if (this.mode === 'on') this.#show(true)
  }

  /** Called after a change of the shading mode, so that the next frame already has relief. */
  resume(): void {
    if (this.#relief && !this.#isOutdated && this.#amountAt(this.#relief.pixelsPerMetre) > 0) this.#show(true)
  }

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
      if (this.isShown && this.#unseen === MAX_UNSEEN) queueMicrotask(() => this.#show(false))
      return
    }
    this.#unseen = 0
    if (!this.isShown || this.#isOutdated) this.#begin()
  }

  /** Frees the dense geometries. Later frames create them again. Must not be called during a frame. */
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
    return bySize && bySize * Math.min(largestActivation(this.#face.faces) / FULL_ACTIVATION, 1)
  }

  /** Shows relief from the next frame on. The current frame cannot show it, because the render lists of the frame already exist. */
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
      if (made) this.#replace(made)
    } catch (error) {
      this.#end()
      this.#warn(error as Error)
    }
  }

  /** Turns relief off, because a mesh or shader does not support it. */
  #limit(limitation: Error): void {
    if (!this.#isPossible) return
    this.#end()
    this.#limitation = limitation
    this.#warnOfLimitation()
  }

  /** Warns of a limitation if the mode is `on`, i.e. if the page explicitly requested relief. */
  #warnOfLimitation(): void {
    if (this.#limitation && this.mode === 'on') this.#warn(this.#limitation)
  }

  /** Warns once per error, because several faces may share the height maps that caused it. */
  #warn(error: Error): void {
    if (warned.has(error)) return
    warned.add(error)
    console.warn(
      this.#isPossible ? error.message : `${error.message} (the wrinkles are shown without relief)`,
    )
  }

  /** Turns relief off permanently, from the next frame on. */
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

  #replace(made: Relief): void {
    const previous = this.#relief
    made.amount.value = previous?.amount.value ?? Number(this.mode === 'on')
    this.#relief = made
    this.#limitation = made.limitation
    this.#warnOfLimitation()
    this.#face.material.setRelief((material) => made.patch(material))
    previous?.dispose()
    this.#show(this.isShown)
  }
}

function largestActivation(faces: readonly Face[]): number {
  let largest = 0
  for (const { activations, slots } of faces) {
    const { values } = activations
    for (let i = 0; i < slots.slots.length; i++) largest = Math.max(largest, values[i])
  }
  return largest
}

const warned = new WeakSet<Error>()
