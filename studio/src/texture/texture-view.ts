import { effect, type ReadonlySignal, signal } from '@preact/signals'
import type { GrayImage } from 'furrow'
import type { Lines } from '../lines/lines.ts'
import type { TextureLineView } from '../lines/texture-line-view.ts'
import type { OpenedAvatar } from '../open/avatar.ts'
import type { PaintSkin } from '../paint/paint-skin.ts'
import type { AreaEditor } from '../session/area-editor.ts'
import type { Session } from '../session/session.ts'
import type { Painting } from '../tools/painting.ts'
import type { Sculpting } from '../tools/sculpting.ts'
import { TextureCamera } from '../tools/texture-camera.ts'
import { ToolHost } from '../tools/tool-host.ts'
import type { Viewer } from '../viewer/viewer.ts'
import { colouredArea } from './area-colours.ts'
import { brushOutline } from './brush-outline.ts'
import { TextureLines } from './texture-lines.ts'
import { drawTexture } from './texture-picture.ts'
import { drawUvPicture } from './uv-picture.ts'

/** Width and height of the skin's picture, texels. */
const PICTURE_SIZE = 1024

export interface TextureViewParts {
  element: HTMLElement
  session: Session
  areas: AreaEditor
  painting: Painting
  sculpting: Sculpting
  lines: Lines
  viewer: ReadonlySignal<Viewer | null>
  /** Runs a task and shows its errors. */
  attempt(task: () => unknown): unknown
}

/** View of the skin's texture with its UV layout, the chosen area and wrinkle lines. Users can paint and edit lines here, as on the face. */
export class TextureView {
  readonly #parts: TextureViewParts
  readonly #canvas = document.createElement('canvas')
  readonly #camera: TextureCamera
  readonly #host: ToolHost
  /** Size of the view in CSS pixels, 0 while it is hidden. */
  #size: readonly [width: number, height: number] = [0, 0]
  readonly #base = signal<HTMLCanvasElement | null>(null)
  readonly #area = document.createElement('canvas')
  readonly #edited: TextureLineView
  #lines: { skin: PaintSkin; size: number; lines: TextureLines } | null = null
  #request = 0

  constructor(parts: TextureViewParts) {
    this.#parts = parts
    const { element, painting, sculpting, lines, viewer, areas, session } = parts
    element.append(this.#canvas)
    this.#camera = new TextureCamera(element, () => this.#wake())
    this.#host = new ToolHost(element, () => this.#camera.camera)
    new ResizeObserver(() => this.#resize()).observe(element)
    painting.addTexture(this.#host, element, this.#camera)
    sculpting.addTexture(this.#host)
    this.#edited = lines.addTexture({ element, host: this.#host }, () => this.#wake())
    let shown: OpenedAvatar | undefined
    effect(() => {
      const avatar = viewer.value?.avatar
      if (avatar?.root === shown?.root && avatar?.skin === shown?.skin) return
      shown = avatar
      this.#base.value = null
      if (avatar) parts.attempt(() => this.#drawBase(avatar))
    })
    effect(() => this.#drawArea(painting.stroke.value ?? areas.chosen.value?.weights))
    effect(() => {
      session.document.value
      painting.hit.value
      painting.skinVersion.value
      painting.brush.value
      sculpting.hit.value
      sculpting.settings.value
      this.#base.value
      this.#wake()
    })
  }

  #drawBase({ skins, skin }: OpenedAvatar): void {
    this.#base.value = drawUvPicture(skins[skin].meshes, PICTURE_SIZE)
  }

  #drawArea(weights: GrayImage | undefined): void {
    this.#area.width = weights?.width ?? 0
    this.#area.height = weights?.height ?? 0
    if (weights) this.#area.getContext('2d')!.putImageData(colouredArea(weights), 0, 0)
    this.#wake()
  }

  #resize(): void {
    const { clientWidth: width, clientHeight: height } = this.#parts.element
    this.#size = [width, height]
    if (width === 0 || height === 0) return
    const ratio = Math.min(devicePixelRatio, 2)
    this.#canvas.width = Math.round(width * ratio)
    this.#canvas.height = Math.round(height * ratio)
    this.#camera.resize(width, height)
  }

  #wake(): void {
    if (this.#request !== 0 || this.#size[0] === 0) return
    this.#request = requestAnimationFrame(() => {
      this.#request = 0
      this.#draw()
    })
  }

  #draw(): void {
    const { painting, sculpting, session, areas } = this.#parts
    painting.polygon.advance()
    const context = this.#canvas.getContext('2d')!
    const ratio = Math.min(devicePixelRatio, 2)
    context.setTransform(ratio, 0, 0, ratio, 0, 0)
    const hit = painting.hit.peek() ?? sculpting.hit.peek()
    const brush = sculpting.isOn.peek() ? sculpting : painting
    const skin = painting.skin
    const document = session.document.peek()
    drawTexture(context, this.#size, this.#camera.frame, {
      base: this.#base.peek(),
      area: areas.chosen.peek() ? this.#area : null,
      lines:
        skin && document
          ? document.strokes.map((stroke) => this.#linesOn(skin, document.areaSize).lineOf(stroke))
          : [],
      outline: hit && skin ? brushOutline(skin, hit.triangle, hit.uv, brush.ringRadius(hit)) : null,
    })
    this.#edited.draw(context, this.#size, this.#camera.frame)
  }

  #linesOn(skin: PaintSkin, size: number): TextureLines {
    if (this.#lines?.skin !== skin || this.#lines.size !== size) {
      this.#lines = { skin, size, lines: new TextureLines(skin, size) }
    }
    return this.#lines.lines
  }
}
