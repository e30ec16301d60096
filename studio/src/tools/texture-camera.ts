import { MOUSE, OrthographicCamera, TOUCH, Vector3 } from 'three'
import { OrbitControls } from 'three/addons/controls/OrbitControls.js'
import { shortcutOf } from '../shortcuts.ts'

/** Border around the texture at zoom 1, as a fraction of the texture's width. */
const BORDER = 0.04
/** Movement per key press at zoom 1, as a fraction of the texture's width. */
const STEP = 0.1
/** Zoom factor per key press. */
const ZOOM_STEP = 1.25
const MAX_ZOOM = 64
/** Minimum jump between two consecutive points of a wrinkle line at a UV seam, as a fraction of the texture's width. Views interrupt the line there. */
export const TEXTURE_JUMP = 0.02

/** Position and size of a texture on screen. */
export interface TextureFrame {
  /** Texture coordinates at the centre of the view, v = 0 at the top. */
  centre: readonly [u: number, v: number]
  /** Width of the texture, CSS pixels. */
  scale: number
}

/** Orthographic camera for a texture. The texture spans 0..1 in x and -1..0 in y. Pointer, wheel, pinch and keys control the camera. */
export class TextureCamera {
  readonly camera = new OrthographicCamera()
  readonly #controls: OrbitControls
  readonly #onChange: () => void
  #width = 1

  /** @param element element that shows the texture. */
  constructor(element: HTMLElement, onChange: () => void) {
    this.#onChange = onChange
    this.camera.position.set(0.5, -0.5, 1)
    this.#controls = new OrbitControls(this.camera, element)
    // The default target is the origin, which would tilt the view.
    this.#controls.target.set(0.5, -0.5, 0)
    this.#controls.update()
    this.#controls.enableRotate = false
    this.#controls.zoomToCursor = true
    this.#controls.minZoom = 1
    this.#controls.maxZoom = MAX_ZOOM
    this.#controls.mouseButtons = { LEFT: MOUSE.PAN, MIDDLE: MOUSE.PAN, RIGHT: MOUSE.PAN }
    this.#controls.touches = { ONE: TOUCH.PAN, TWO: TOUCH.DOLLY_PAN }
    this.#controls.addEventListener('change', () => {
      this.#stayOnTexture()
      onChange()
    })
    element.tabIndex = 0
    element.addEventListener('keydown', this.#onKey)
  }

  get frame(): TextureFrame {
    const { position, zoom, left, right } = this.camera
    return { centre: [position.x, -position.y], scale: (this.#width * zoom) / (right - left) }
  }

  /** Adapts to the element's size in CSS pixels. */
  resize(width: number, height: number): void {
    const half = (0.5 + BORDER) * Math.max(1, width / height, height / width)
    const [x, y] = width < height ? [half * (width / height), half] : [half, half * (height / width)]
    Object.assign(this.camera, { left: -x, right: x, top: y, bottom: -y })
    this.#width = width
    this.#apply()
  }

  reset(): void {
    this.camera.zoom = 1
    this.#moveTo(0.5, -0.5)
    this.#apply()
  }

  #stayOnTexture(): void {
    const { x, y } = this.camera.position
    this.#moveTo(Math.min(1, Math.max(0, x)), Math.min(0, Math.max(-1, y)))
  }

  #moveTo(x: number, y: number): void {
    this.camera.position.set(x, y, 1)
    this.#controls.target.copy(new Vector3(x, y, 0))
  }

  #apply(): void {
    this.camera.updateProjectionMatrix()
    this.camera.updateMatrixWorld()
    this.#onChange()
  }

  readonly #onKey = (event: KeyboardEvent): void => {
    const name = shortcutOf('texture', event)
    if (!name) return
    event.preventDefault()
    if (name === 'reset') {
      this.reset()
      return
    }
    const { position, zoom } = this.camera
    const step = STEP / zoom
    const moves: Record<typeof name, readonly [x: number, y: number, factor: number]> = {
      left: [-step, 0, 1],
      right: [step, 0, 1],
      up: [0, step, 1],
      down: [0, -step, 1],
      nearer: [0, 0, ZOOM_STEP],
      farther: [0, 0, 1 / ZOOM_STEP],
    }
    const [x, y, factor] = moves[name]
    this.camera.zoom = Math.min(MAX_ZOOM, Math.max(1, zoom * factor))
    this.#moveTo(position.x + x, position.y + y)
    this.#stayOnTexture()
    this.#apply()
  }
}
