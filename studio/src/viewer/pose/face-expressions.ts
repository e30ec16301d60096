import type { Expression } from 'furrow'
import { ExpressionPlayer } from 'furrow/three'
import type { Object3D } from 'three'
import type { Wrinkles } from '../../../../stage/stage.ts'
import { completeExpressions } from './expressions.ts'
import type { FaceDrivers } from './face-drivers.ts'

/** Expressions of the face, and transitions between them. */
export class FaceExpressions {
  readonly #root: Object3D
  readonly #vrm: readonly Expression[]
  /** Null for a face without blendshapes. */
  #player: ExpressionPlayer | null = null
  #list: readonly Expression[] = []
  /** Remaining seconds of the transition. */
  #remaining = 0

  constructor(root: Object3D, vrm: readonly Expression[]) {
    this.#root = root
    this.#vrm = vrm
  }

  /** Rebuilds the expressions for changed drivers, blendshapes or areas. Stops a running transition. */
  rebuild(
    drivers: FaceDrivers,
    wrinkles: Wrinkles | null,
    targetNames: readonly string[],
    areaNames: readonly string[],
  ): void {
    const restOf = (area: string) => wrinkles?.getArea(area)?.activation ?? 0
    this.#list = completeExpressions(drivers, this.#vrm, targetNames, areaNames, restOf)
    this.#player =
      targetNames.length === 0 ? null : new ExpressionPlayer(this.#root, wrinkles ?? undefined, this.#list)
  }

  get list(): readonly Expression[] {
    return this.#list
  }

  get isMoving(): boolean {
    return this.#remaining > 0
  }

  /** Whether expressions set an area directly. Other areas follow their drivers. */
  setsArea(area: string): boolean {
    return this.#list.slice(1).some(({ activations }) => area in activations)
  }

  /** Starts a transition to an expression from the current state. */
  play(name: string, seconds: number): void {
    if (!this.#player) return
    this.#player.play(name, seconds)
    this.#remaining = seconds
  }

  /** @param delta seconds since the last frame; infinity ends the transition. */
  advance(delta: number): void {
    this.#player?.update(delta)
    this.#remaining = Math.max(0, this.#remaining - delta)
  }

  stop(): void {
    this.#remaining = 0
  }
}
