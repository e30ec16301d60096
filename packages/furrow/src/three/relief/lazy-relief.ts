import type { Camera, Mesh } from 'three'
import { checkReliefMode, type ReliefMode } from '../options.ts'
import type { AnyRenderer } from '../renderer.ts'
import type { RaisedFace } from './raised-face.ts'
import { hasHeights } from './raised-layer.ts'
import type { CreateRelief, ReliefControl } from './relief-control.ts'

/** Relief of a face: displacement of its surface by height maps. Downloads the code for relief on first use, if a layer has a height map. */
export class LazyRelief {
  readonly #face: RaisedFace
  readonly #load: () => Promise<CreateRelief>
  #mode: ReliefMode = 'off'
  #control: ReliefControl | null = null

  /** @param load downloads the code for relief. */
  constructor(face: RaisedFace, load: () => Promise<CreateRelief>) {
    this.#face = face
    this.#load = load
  }

  get mode(): ReliefMode {
    return this.#mode
  }

  /** @throws FurrowError if the mode is unknown. */
  set mode(mode: ReliefMode) {
    this.#face.checkInUse('relief')
    checkReliefMode(mode)
    this.#mode = mode
    if (this.#control) this.#control.mode = mode
    else if (mode !== 'off') this.#fetch().catch(({ message }) => console.warn(message))
  }

  /** Whether the face is drawn with relief. */
  get isShown(): boolean {
    return this.#control?.isShown ?? false
  }

  /** Prepares relief now instead of on first use. Resolves when relief can be drawn. */
  async ready(): Promise<void> {
    this.#face.checkInUse('reliefReady')
    await (await this.#fetch())?.ready()
  }

  /** Called after a change of the shading mode, so that the next frame already has relief. */
  resume(): void {
    this.#control?.resume()
  }

  prepare(renderer: AnyRenderer, camera: Camera, mesh: Mesh): void {
    this.#control?.prepare(renderer, camera, mesh)
  }

  /** Frees the resources of relief. Later frames create them again. */
  suspend(): void {
    this.#control?.suspend()
  }

  dispose(): void {
    this.#control?.dispose()
  }

  async #fetch(): Promise<ReliefControl | null> {
    if (!this.#face.shaderInputs.textures.layers.some(hasHeights)) return null
    const createRelief = await this.#load()
    if (this.#face.isDisposed) return null
    this.#control ??= createRelief(this.#face, this.#mode)
    return this.#control
  }
}
