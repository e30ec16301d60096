import { Spherical, Vector3 } from 'three'
import { OrbitControls } from 'three/addons/controls/OrbitControls.js'
import type { Stage } from '../../stage/stage.ts'
import type { ViewName } from '../../stage/views.ts'

/** Seconds from one view to the next. */
const GLIDE = 0.45
/** Radians per key press. */
const TURN = Math.PI / 36
const ZOOM = 1.08

/** Where a camera stands and what it looks at. */
export interface Pose {
  position: Vector3
  target: Vector3
}

/** Orbits the camera by pointer, touch and keys, and glides it to the fixed views. */
export class Orbit {
  readonly #stage: Stage
  readonly #element: HTMLElement
  readonly #controls: OrbitControls
  #glide: { from: Pose; to: Pose; elapsed: number } | null = null
  readonly #still: boolean
  #settled = true
  #nearest = Infinity
  #farthest = 0
  #view: ViewName | null = null

  /** @param still moves at once instead of gliding and swinging out. */
  constructor(stage: Stage, element: HTMLElement, still: boolean, onChange: () => void) {
    this.#stage = stage
    this.#element = element
    this.#still = still
    this.#controls = new OrbitControls(stage.camera, element)
    this.#controls.enableDamping = !still
    this.#controls.dampingFactor = 0.12
    this.#controls.addEventListener('start', () => {
      this.#leaveView()
    })
    this.#controls.addEventListener('change', onChange)
    element.tabIndex = 0
    element.addEventListener('keydown', this.#onKey)
  }

  get pose(): Pose {
    return { position: this.#stage.camera.position.clone(), target: this.#controls.target.clone() }
  }

  set pose({ position, target }: Pose) {
    this.#stage.camera.position.copy(position)
    this.#controls.target.copy(target)
    this.#controls.update()
  }

  /** Whether the camera is still under way. */
  get moving(): boolean {
    return this.#glide !== null || !this.#settled
  }

  /** The fixed view it stands at or glides to, null once turned by hand. */
  get view(): ViewName | null {
    return this.#view
  }

  /** @param atOnce where the next picture shall show it already. */
  goTo(name: ViewName, atOnce = false): void {
    const from = this.pose
    const { camera } = this.#stage
    const target = this.#stage.view(name)
    const to = { position: camera.position.clone(), target }
    this.#reach(to.position.distanceTo(target))
    this.#glide = atOnce || this.#still ? null : { from, to, elapsed: 0 }
    this.pose = this.#glide ? from : to
    this.#view = name
  }

  /** Stands where another camera stood. */
  restore(pose: Pose, view: ViewName | null): void {
    this.goTo(view ?? 'front', true)
    this.pose = pose
    this.#view = view
  }

  /** @param delta seconds since the last frame. */
  advance(delta: number): void {
    if (this.#glide) {
      this.#glide.elapsed += delta
      const share = Math.min(this.#glide.elapsed / GLIDE, 1)
      this.pose = between(this.#glide.from, this.#glide.to, share * share * (3 - 2 * share))
      if (share === 1) this.#glide = null
    }
    this.#settled = !this.#controls.update()
  }

  dispose(): void {
    this.#element.removeEventListener('keydown', this.#onKey)
    this.#controls.dispose()
  }

  /** Widens what the wheel and the picture's depth reach, so that every view may be turned from every other. */
  #reach(distance: number): void {
    const { camera } = this.#stage
    this.#nearest = Math.min(this.#nearest, distance * 0.25)
    this.#farthest = Math.max(this.#farthest, distance * 2.5)
    this.#controls.minDistance = this.#nearest
    this.#controls.maxDistance = this.#farthest
    camera.near = this.#nearest / 10
    camera.far = this.#farthest * 2
    camera.updateProjectionMatrix()
  }

  #leaveView(): void {
    this.#glide = null
    this.#view = null
  }

  readonly #onKey = (event: KeyboardEvent): void => {
    const act: Record<string, () => void> = {
      ArrowLeft: () => this.#controls.rotateLeft(TURN),
      ArrowRight: () => this.#controls.rotateLeft(-TURN),
      ArrowUp: () => this.#controls.rotateUp(TURN),
      ArrowDown: () => this.#controls.rotateUp(-TURN),
      '+': () => this.#controls.dollyIn(1 / ZOOM),
      '=': () => this.#controls.dollyIn(1 / ZOOM),
      '-': () => this.#controls.dollyIn(ZOOM),
    }
    if (!act[event.key] || event.altKey || event.ctrlKey || event.metaKey) return
    event.preventDefault()
    this.#leaveView()
    act[event.key]()
  }
}

/** Round the face, not through it. */
function between(from: Pose, to: Pose, share: number): Pose {
  const target = from.target.clone().lerp(to.target, share)
  const [a, b] = [from, to].map((pose) =>
    new Spherical().setFromVector3(pose.position.clone().sub(pose.target)),
  )
  const turn = Math.atan2(Math.sin(b.theta - a.theta), Math.cos(b.theta - a.theta))
  const offset = new Vector3().setFromSpherical(
    new Spherical(
      a.radius + (b.radius - a.radius) * share,
      a.phi + (b.phi - a.phi) * share,
      a.theta + turn * share,
    ),
  )
  return { target, position: target.clone().add(offset) }
}
