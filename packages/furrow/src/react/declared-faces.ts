import type { Object3D } from 'three'
import type { ExpressionChoice } from '../runtime/expression-mix.ts'
import { ExpressionPlayer } from '../three/ExpressionPlayer.ts'
import type { WrinklesBase } from '../three/wrinkles-base.ts'
import { DeclaredFace } from './declared-face.ts'
import type { WrinkleState } from './wrinkle-state.ts'

/** Applies the properties of a React component to all faces of an object. Faces may be added and removed between frames. */
export class DeclaredFaces {
  readonly #known = new Map<WrinklesBase, DeclaredFace>()
  readonly #warned = new Set<string>()
  #player: ExpressionPlayer | null = null
  /** Whether faces were added or removed since the player was created. If so, a new player must be created. */
  #isStale = true
  #playing: ExpressionChoice | undefined

  /**
   * Applies a state to faces, and advances the transition to their expression by one frame.
   *
   * @param root root object of the meshes whose blendshapes the expression moves.
   * @param faces current faces.
   * @param seconds time since the last frame.
   * @returns whether an expression is still playing, so that another frame is needed.
   */
  update(root: Object3D, faces: readonly WrinklesBase[], state: WrinkleState, seconds: number): boolean {
    for (const face of this.#known.keys()) {
      if (faces.includes(face)) continue
      this.#known.delete(face)
      this.#isStale = true
    }
    for (const face of faces) {
      if (!this.#known.has(face)) {
        this.#known.set(face, new DeclaredFace(face, this.#warn))
        this.#isStale = true
      }
      this.#known.get(face)!.apply(state)
    }
    this.#express(root, faces[0], state.expression)
    this.#player?.update(seconds)
    return this.#player?.isPlaying ?? false
  }

  /** Restores the original state of all faces. */
  release(): void {
    for (const face of this.#known.values()) face.apply({})
    this.#known.clear()
    if (this.#playing !== undefined) this.#player?.play({}, 0)
    this.#isStale = true
    this.#playing = undefined
  }

  /** Plays an expression if the expression or the list of faces has changed. Without an expression, the page controls the blendshapes. */
  #express(root: Object3D, face: WrinklesBase | undefined, expression: ExpressionChoice | undefined): void {
    const isNew = !isSame(expression, this.#playing)
    if (!isNew && (expression === undefined || !this.#isStale)) return
    this.#playing = expression
    try {
      if (this.#isStale) {
        this.#player = null
        this.#isStale = false
        this.#player = new ExpressionPlayer(root, face)
      }
      this.#player?.play(expression ?? {})
    } catch (error) {
      this.#warn(error)
    }
  }

  readonly #warn = (error: unknown) => {
    const text = error instanceof Error ? error.message : String(error)
    if (this.#warned.has(text)) return
    this.#warned.add(text)
    console.warn(text)
  }
}

/** Compares the names and weights of two expressions. Comparing objects by `===` is not enough, because JSX creates new objects. */
function isSame(a: ExpressionChoice | undefined, b: ExpressionChoice | undefined): boolean {
  if (a === b || typeof a !== 'object' || typeof b !== 'object') return a === b
  const names = Object.keys(a)
  return names.length === Object.keys(b).length && names.every((name) => a[name] === b[name])
}
