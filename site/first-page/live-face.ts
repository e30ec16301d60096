/**
 * Shows the face on the first page of the site. The face follows the pointer. A frame is rendered only after a change.
 */

import { EXPRESSIONS, type Expression } from 'furrow'
import { ExpressionPlayer, frameFace, type WrinklesBase, wrinklesOf, wrinklesReady } from 'furrow/three'
import {
  ACESFilmicToneMapping,
  DirectionalLight,
  HemisphereLight,
  type Object3D,
  PerspectiveCamera,
  PMREMGenerator,
  Scene,
  Spherical,
  Vector3,
  WebGLRenderer,
} from 'three'
import { RoomEnvironment } from 'three/addons/environments/RoomEnvironment.js'
import { type AvatarFile, type AvatarOptions, loadAvatar } from './load-avatar.ts'

/** Fade time when the face follows the pointer, seconds. */
const FOLLOW = 0.12
/** Fade time of an expression that a button selects, seconds. */
const CHANGE = 0.35

/** Largest rotation of the camera around the face, radians. There is no rotation with `prefers-reduced-motion`. */
const YAW = 0.2
const PITCH = 0.1
/** Fraction of the remaining rotation that one frame covers. */
const EASE = 0.12

/** Time for which frames are rendered after the last change, milliseconds. */
const LINGER = 600

/** Zoom of `frameFace`. At its default zoom, the face would be smaller. */
const ZOOM = 1.28

/** Expression that the face shows if the pointer is above, below, right or left of it. */
const UP = 'surprised'
const DOWN = 'angry'
const RIGHT = 'happy'
const LEFT = 'disgusted'

const NAMES = ['neutral', UP, DOWN, RIGHT, LEFT]

/** Blendshapes that turn the eyes to a side of the image. The left eye is on the right side of the image. */
const GAZES: readonly Expression[] = [
  gaze('gazeUp', { eyeLookUpLeft: 0.6, eyeLookUpRight: 0.6 }),
  gaze('gazeDown', { eyeLookDownLeft: 0.5, eyeLookDownRight: 0.5 }),
  gaze('gazeRight', { eyeLookOutLeft: 0.6, eyeLookInRight: 0.6 }),
  gaze('gazeLeft', { eyeLookInLeft: 0.6, eyeLookOutRight: 0.6 }),
]

function gaze(name: string, targets: Record<string, number>): Expression {
  return { name, targets, activations: {} }
}

/** Expressions without activations. The drivers of the file compute activations from the blendshapes. */
const PLAYED = [
  ...EXPRESSIONS.filter(({ name }) => NAMES.includes(name)).map((expression) => ({
    ...expression,
    activations: {},
  })),
  ...GAZES,
]

export class LiveFace {
  readonly #renderer: WebGLRenderer
  readonly #scene = new Scene()
  readonly #camera = new PerspectiveCamera()
  #face: Object3D | undefined
  #player: ExpressionPlayer | undefined
  #wrinkles: WrinklesBase | undefined
  #wrinkled = true
  readonly #target = new Vector3()
  /** Position of the camera relative to `#target`, while the pointer is at the centre of the face. */
  readonly #rest = new Spherical()
  /** `#aim` is the position of the pointer, -1..1. `#now` follows it smoothly and moves the camera. */
  readonly #aim = { x: 0, y: 0 }
  readonly #now = { x: 0, y: 0 }
  readonly #isCalm = matchMedia('(prefers-reduced-motion: reduce)')
  /** Rendering stops at this time of `performance.now()`, milliseconds. */
  #drawnUntil = 0

  /** @throws Error if the browser has no WebGL 2. */
  constructor(canvas: HTMLCanvasElement) {
    this.#renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true })
    this.#renderer.toneMapping = ACESFilmicToneMapping
    this.#light()
    const observer = new ResizeObserver(() => this.#resize())
    observer.observe(canvas)
    canvas.addEventListener('webglcontextrestored', () => this.#draw())
    this.#renderer.setAnimationLoop(() => this.#frame())
  }

  /**
   * Replaces the avatar. Generates wrinkles if the file has none.
   *
   * @returns whether the avatar has wrinkles. Also true if another avatar replaced it before its wrinkles were ready.
   * @throws Error if the file cannot be read.
   */
  async show(file: AvatarFile, options?: AvatarOptions): Promise<boolean> {
    const avatar = await loadAvatar(file, this.#renderer, options)
    // An expression player needs blendshapes.
    const player = hasBlendshapes(avatar.scene)
      ? new ExpressionPlayer(avatar.scene, wrinklesOf(avatar)[0], PLAYED)
      : undefined
    if (this.#face) this.#scene.remove(this.#face)
    this.#face = avatar.scene
    this.#player = player
    this.#wrinkles = undefined
    this.#scene.add(avatar.scene)
    this.#resize()
    this.express(UP)
    const [wrinkles] = await wrinklesReady(avatar)
    if (this.#face !== avatar.scene) return true
    this.#wrinkles = wrinkles
    this.wrinkled = this.#wrinkled
    return wrinkles !== undefined
  }

  get wrinkled(): boolean {
    return this.#wrinkled
  }

  set wrinkled(wrinkled: boolean) {
    this.#wrinkled = wrinkled
    if (this.#wrinkles) this.#wrinkles.mode = wrinkled ? 'default' : 'off'
    this.#draw()
  }

  /**
   * Makes the face look at the pointer and react to it.
   *
   * @param x position right of the centre of the face, -1..1.
   * @param y position below the centre of the face, -1..1.
   */
  aim(x: number, y: number): void {
    const far = Math.min(1, Math.hypot(x, y))
    const part = (along: number) => Math.min(1, Math.max(0, along * (0.4 + 0.6 * far)))
    Object.assign(this.#aim, { x: clamp(x), y: clamp(y) })
    this.#player?.play(
      {
        [UP]: part(-y),
        [DOWN]: part(y),
        [RIGHT]: part(x),
        [LEFT]: part(-x),
        gazeUp: part(-y),
        gazeDown: part(y),
        gazeRight: part(x),
        gazeLeft: part(-x),
      },
      FOLLOW,
      'easeOut',
    )
    this.#draw()
  }

  express(name: string): void {
    Object.assign(this.#aim, { x: 0, y: 0 })
    this.#player?.play(name, CHANGE, 'easeInOut')
    this.#draw()
  }

  #light(): void {
    const pmrem = new PMREMGenerator(this.#renderer)
    const room = new RoomEnvironment()
    this.#scene.environment = pmrem.fromScene(room, 0.04).texture
    this.#scene.environmentIntensity = 0.3
    room.dispose()
    pmrem.dispose()
    const key = new DirectionalLight('#fff1e4', 3.1)
    key.position.set(-1, 1.35, 0.95)
    const rim = new DirectionalLight('#e6eeff', 1.3)
    rim.position.set(1.2, 1, -1.4)
    this.#scene.add(key, rim, new HemisphereLight('#dfe8ff', '#4b3a32', 0.35))
  }

  #resize(): void {
    const { clientWidth: width, clientHeight: height } = this.#renderer.domElement
    if (width === 0 || height === 0) return
    this.#renderer.setPixelRatio(Math.min(devicePixelRatio, 2))
    this.#renderer.setSize(width, height, false)
    this.#camera.aspect = width / height
    this.#camera.fov = 22
    if (this.#face) {
      this.#target.copy(frameFace(this.#camera, this.#face, { zoom: ZOOM }))
      this.#rest.setFromVector3(this.#camera.position.clone().sub(this.#target))
    }
    this.#camera.updateProjectionMatrix()
    this.#draw()
  }

  /** Renders frames for the next `LINGER` milliseconds, because wrinkles fade in over several frames. */
  #draw(): void {
    this.#drawnUntil = performance.now() + LINGER
  }

  #frame(): void {
    if (!this.#face) return
    const isMoving = this.#follow() || this.#player?.isPlaying
    if (isMoving) this.#draw()
    else if (performance.now() > this.#drawnUntil) return
    this.#player?.update()
    this.#renderer.render(this.#scene, this.#camera)
  }

  /**
   * Rotates the camera around the face, so that the face turns towards the pointer. The camera moves to the left if the
   * pointer is right of the face, and up if the pointer is below it. Returns whether the camera is still moving.
   */
  #follow(): boolean {
    const { x, y } = this.#aim
    const [dx, dy] = [x - this.#now.x, y - this.#now.y]
    this.#now.x += EASE * dx
    this.#now.y += EASE * dy
    const { radius, phi, theta } = this.#rest
    const reach = this.#isCalm.matches ? 0 : 1
    this.#camera.position
      .setFromSphericalCoords(radius, phi - reach * PITCH * this.#now.y, theta - reach * YAW * this.#now.x)
      .add(this.#target)
    this.#camera.lookAt(this.#target)
    return Math.hypot(dx, dy) > 0.004
  }
}

const clamp = (value: number) => Math.min(1, Math.max(-1, value))

function hasBlendshapes(face: Object3D): boolean {
  let found = false
  face.traverse((object) => {
    if ((object as { morphTargetInfluences?: number[] }).morphTargetInfluences?.length) found = true
  })
  return found
}
