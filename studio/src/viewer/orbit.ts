import { smoothstep } from 'furrow/internal'
import { Spherical, Vector3 } from 'three'
import { OrbitControls } from 'three/addons/controls/OrbitControls.js'
import type { Stage } from '../../../stage/stage.ts'
import type { ViewName } from '../../../stage/views.ts'
import { type ShortcutName, shortcutOf } from '../shortcuts.ts'

/** Duration of a transition between views, seconds. */
const TRANSITION_TIME = 0.45
/** Speed of the turntable for `OrbitControls`, in turns per minute. */
const TURNTABLE_SPEED = 4
/** Rotation per key press, radians. */
const ROTATION_STEP = Math.PI / 36
/** Zoom factor per key press. */
const ZOOM_STEP = 1.08

/** Half width of the middle of the picture in which a sphere counts as seen, as a fraction of half the picture. */
const SEEN = 0.85
/** Height of a sphere that counts as seen, as a fraction of the picture's height. */
const VISIBLE = 0.15

/** Position and target of a camera. */
export interface Pose {
  position: Vector3
  target: Vector3
}

/** Orbits the camera by pointer, touch and keys, with smooth transitions to fixed views. */
export class Orbit {
  readonly #stage: Stage
  readonly #element: HTMLElement
  readonly #controls: OrbitControls
  #transition: { from: Pose; to: Pose; elapsed: number } | null = null
  readonly #reducedMotion: boolean
  #atRest = true
  #nearest = Infinity
  #farthest = 0
  #view: ViewName | null = null

  /** @param reducedMotion whether to disable transitions and damping. */
  constructor(stage: Stage, element: HTMLElement, reducedMotion: boolean, onChange: () => void) {
    this.#stage = stage
    this.#element = element
    this.#reducedMotion = reducedMotion
    this.#controls = new OrbitControls(stage.camera, element)
    this.#controls.enableDamping = !reducedMotion
    this.#controls.dampingFactor = 0.12
    this.#controls.zoomToCursor = true
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

  get isMoving(): boolean {
    return this.#transition !== null || !this.#atRest || this.#controls.autoRotate
  }

  /** Whether the camera orbits automatically. */
  set turntable(isOn: boolean) {
    if (isOn === this.#controls.autoRotate) return
    this.#controls.autoRotate = isOn
    this.#controls.autoRotateSpeed = TURNTABLE_SPEED
    if (isOn) this.#leaveView()
  }

  /** Fixed view that the camera has or moves to. Null after the user has orbited the camera. */
  get view(): ViewName | null {
    return this.#view
  }

  /** Fits the face into the current fixed view again. Call after the canvas's aspect ratio or the face has changed. */
  frame(immediate = false): void {
    if (this.#view) this.goTo(this.#view, immediate)
  }

  /** Moves to a fixed view. @param immediate whether to skip the transition, so that the next frame shows the view. */
  goTo(name: ViewName, immediate = false): void {
    const from = this.pose
    const { camera } = this.#stage
    const target = this.#stage.view(name)
    const to = { position: camera.position.clone(), target }
    this.#extendRange(to.position.distanceTo(target))
    this.#transition = immediate || this.#reducedMotion ? null : { from, to, elapsed: 0 }
    this.pose = this.#transition ? from : to
    this.#view = name
  }

  /**
   * Moves the camera without turning it, until a sphere is in the middle and a third as high as the picture.
   *
   * @param target centre of the sphere, world space.
   */
  lookAt(target: Vector3, radius: number): void {
    const from = this.pose
    const { fov } = this.#stage.camera
    const wanted = (3 * radius) / Math.tan((fov * Math.PI) / 360)
    const distance = Math.min(Math.max(wanted, this.#nearest), this.#farthest)
    const direction = from.position.clone().sub(from.target).normalize()
    const to = { target, position: target.clone().addScaledVector(direction, distance) }
    this.#view = null
    this.#transition = this.#reducedMotion ? null : { from, to, elapsed: 0 }
    this.pose = this.#transition ? from : to
  }

  /**
   * Looks at a sphere like `lookAt`, unless the sphere is in the picture and at least `VISIBLE` of the picture's height.
   *
   * @returns the horizontal position of the sphere in the picture after the move, 0 (left edge) to 1 (right edge).
   */
  show(target: Vector3, radius: number): number {
    const { camera } = this.#stage
    camera.updateMatrixWorld()
    const { x, y } = target.clone().project(camera)
    const half = camera.position.distanceTo(target) * Math.tan((camera.fov * Math.PI) / 360)
    const isShown = Math.max(Math.abs(x), Math.abs(y)) <= SEEN && radius >= VISIBLE * half
    if (!isShown) this.lookAt(target, radius)
    return isShown ? (x + 1) / 2 : 0.5
  }

  /** Applies the pose and the fixed view of another `Orbit`. */
  restore(pose: Pose, view: ViewName | null): void {
    this.goTo(view ?? 'front', true)
    this.pose = pose
    this.#view = view
  }

  /** @param delta seconds since the last frame. */
  advance(delta: number): void {
    if (this.#transition) {
      this.#transition.elapsed += delta
      const t = Math.min(this.#transition.elapsed / TRANSITION_TIME, 1)
      this.pose = interpolatePose(this.#transition.from, this.#transition.to, smoothstep(t))
      if (t === 1) this.#transition = null
    }
    this.#atRest = !this.#controls.update(delta)
  }

  dispose(): void {
    this.#element.removeEventListener('keydown', this.#onKey)
    this.#controls.dispose()
  }

  /** Extends the ranges of zoom and depth to include a camera distance. The ranges never shrink. */
  #extendRange(distance: number): void {
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
    this.#transition = null
    this.#view = null
  }

  readonly #onKey = (event: KeyboardEvent): void => {
    const actions: Record<ShortcutName<'face'>, () => void> = {
      left: () => this.#controls.rotateLeft(ROTATION_STEP),
      right: () => this.#controls.rotateLeft(-ROTATION_STEP),
      up: () => this.#controls.rotateUp(ROTATION_STEP),
      down: () => this.#controls.rotateUp(-ROTATION_STEP),
      nearer: () => this.#controls.dollyIn(1 / ZOOM_STEP),
      farther: () => this.#controls.dollyIn(ZOOM_STEP),
    }
    const name = shortcutOf('face', event)
    if (!name) return
    event.preventDefault()
    this.#leaveView()
    actions[name]()
  }
}

/** Interpolates in spherical coordinates, so that the camera moves around the face and not through it. */
function interpolatePose(from: Pose, to: Pose, t: number): Pose {
  const target = from.target.clone().lerp(to.target, t)
  const [a, b] = [from, to].map((pose) =>
    new Spherical().setFromVector3(pose.position.clone().sub(pose.target)),
  )
  const rotation = Math.atan2(Math.sin(b.theta - a.theta), Math.cos(b.theta - a.theta))
  const offset = new Vector3().setFromSpherical(
    new Spherical(a.radius + (b.radius - a.radius) * t, a.phi + (b.phi - a.phi) * t, a.theta + rotation * t),
  )
  return { target, position: target.clone().add(offset) }
}
