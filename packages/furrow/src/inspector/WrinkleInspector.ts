import { GUI } from 'three/addons/libs/lil-gui.module.min.js'
import { wrongArgument } from '../core/argument.ts'
import type { ReliefMode, WrinkleMode } from '../three/options.ts'
import { WrinklesBase } from '../three/wrinkles-base.ts'
import { AreaList } from './area-list.ts'
import { FaceView, viewsOf } from './face-view.ts'

/** Milliseconds between updates of the panel's text. */
const INTERVAL = 100

/** On pages narrower than this, in CSS pixels, the panel starts collapsed, because it would cover the face. */
const NARROW = 640

const MODES: readonly WrinkleMode[] = ['default', 'composed', 'paper', 'off']
const RELIEF_MODES: readonly ReliefMode[] = ['off', 'near', 'on']

/**
 * A panel to inspect the wrinkles of one face. It lists the activation of each area and the inputs that drive the area. It shows the cost:
 * the number of active areas, textures and triangles. The page's user can choose the shading mode, the relief mode, and a view (for example
 * normals or strain). The panel works with `WebGLRenderer` and `WebGPURenderer`.
 *
 * The panel is a `GUI` of lil-gui in the top right corner of the page. It is removed when the wrinkles are disposed of.
 *
 * @example
 * ```ts
 * import { WrinkleInspector } from 'furrow/inspector'
 *
 * const inspector = new WrinkleInspector(wrinklesOf(gltf)[0])
 * ```
 */
export class WrinkleInspector {
  /** The panel. A page can collapse it, or add controls to it. */
  readonly gui: GUI
  readonly #wrinkles: WrinklesBase
  readonly #view: FaceView
  readonly #areas: AreaList
  /** Texts in the folder "Cost" of the panel. */
  readonly #cost = { areas: '', textures: '', triangles: '' }
  #frame = 0
  #lastUpdate = -Infinity

  /**
   * @param wrinkles wrinkles of the face to inspect, e.g. `wrinklesOf(gltf)[0]`.
   * @throws FurrowError if `wrinkles` is not an object of `furrow/three` or `furrow/webgpu`.
   */
  constructor(wrinkles: WrinklesBase) {
    if (!(wrinkles instanceof WrinklesBase))
      throw wrongArgument(
        'WrinkleInspector',
        'wrinkles',
        wrinkles,
        'wrinkles of furrow/three or furrow/webgpu',
      )
    this.#wrinkles = wrinkles
    this.#view = new FaceView(wrinkles)
    this.gui = new GUI({ title: `Wrinkles of ${wrinkles.mesh.name || 'a mesh'}`, width: 300 })
    this.#addDisplay()
    const folder = this.gui.addFolder('Areas')
    this.#areas = new AreaList(wrinkles, folder)
    if (wrinkles.faceCount > 1)
      folder.add(this.#areas, 'instance', 0, wrinkles.faceCount - 1, 1).name('Instance')
    const cost = this.gui.addFolder('Cost')
    cost.add(this.#cost, 'areas').name('Active areas').listen().disable()
    cost.add(this.#cost, 'textures').name('Textures').listen().disable()
    cost.add(this.#cost, 'triangles').name('Triangles').listen().disable()
    if (innerWidth < NARROW) this.gui.close()
    wrinkles.onDispose(() => this.dispose())
    this.#loop(0)
  }

  /** Removes the panel and restores the original material of the face. */
  dispose(): void {
    cancelAnimationFrame(this.#frame)
    this.#view.dispose()
    this.gui.destroy()
  }

  #addDisplay(): void {
    const [wrinkles, { gui }] = [this.#wrinkles, this]
    // Setting the mode throws if the material or the wrinkle set does not support it, as can happen with `paper`.
    const display = {
      get mode() {
        return wrinkles.mode
      },
      set mode(mode) {
        try {
          wrinkles.mode = mode
        } catch (error) {
          console.warn((error as Error).message)
        }
      },
    }
    gui
      .add(this.#view, 'view', [...viewsOf(wrinkles)])
      .name('View')
      .listen()
    gui
      .add(display, 'mode', [...MODES])
      .name('Mode')
      .listen()
    gui
      .add(wrinkles, 'relief', [...RELIEF_MODES])
      .name('Relief')
      .listen()
    gui.add(wrinkles, 'driven').name('Drivers').listen()
  }

  #loop(time: number): void {
    this.#frame = requestAnimationFrame((now) => this.#loop(now))
    this.#view.follow()
    if (time - this.#lastUpdate < INTERVAL) return
    this.#lastUpdate = time
    this.#areas.update()
    this.#measureCost()
  }

  #measureCost(): void {
    const { areaNames, faceCount, statistics } = this.#wrinkles
    const { activeAreas, textures, textureBytes, triangles } = statistics
    this.#cost.areas = `${activeAreas} of ${areaNames.length * faceCount}`
    this.#cost.textures = `${textures}, ${(textureBytes / 2 ** 20).toFixed(1)} MB`
    this.#cost.triangles = `${triangles}`
  }
}
