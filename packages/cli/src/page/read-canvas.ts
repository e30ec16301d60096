import { type PerspectiveCamera, RenderTarget } from 'three'
import type { WebGPURenderer } from 'three/webgpu'
import { isWebGL } from '../../../../stage/light.ts'
import type { Stage } from '../../../../stage/stage.ts'

/** Draws a tile of the image. Returns RGBA bytes, row 0 at the top. */
type DrawTile = () => Promise<Uint8Array>

/** Width and height of a tile, pixels. The multisampled buffers of a whole image could exceed the GPU's memory. */
const TILE = 2048

/**
 * Draws the stage as on screen (multisampled, tone mapped, sRGB) and reads the pixels.
 *
 * @returns RGBA bytes, row 0 at the top.
 */
export async function readPicture(stage: Stage, width: number, height: number): Promise<Uint8Array> {
  const tileWidth = Math.min(width, TILE)
  const tileHeight = Math.min(height, TILE)
  stage.renderer.setPixelRatio(1)
  stage.renderer.setSize(tileWidth, tileHeight, false)
  const draw = isWebGL(stage.renderer) ? canvasTile(stage) : targetTile(stage, tileWidth, tileHeight)
  const picture = new Uint8Array(width * height * 4)
  for (let y = 0; y < height; y += TILE) {
    for (let x = 0; x < width; x += TILE) {
      setTile(stage.camera, width, height, x, y, tileWidth, tileHeight)
      const tile = await draw()
      const [columns, rows] = [Math.min(tileWidth, width - x), Math.min(tileHeight, height - y)]
      for (let row = 0; row < rows; row++) {
        const from = row * tileWidth * 4
        picture.set(tile.subarray(from, from + columns * 4), ((y + row) * width + x) * 4)
      }
    }
  }
  return picture
}

function setTile(
  camera: PerspectiveCamera,
  ...[width, height, x, y, tileWidth, tileHeight]: [number, number, number, number, number, number]
): void {
  camera.setViewOffset(width, height, x, y, tileWidth, tileHeight)
  camera.updateProjectionMatrix()
}

/**
 * Reads tiles from the canvas right after drawing. WebGLRenderer applies tone mapping only when it draws to the canvas.
 */
function canvasTile(stage: Stage): DrawTile {
  const gl = stage.renderer.getContext() as WebGL2RenderingContext
  const { drawingBufferWidth: width, drawingBufferHeight: height } = gl
  const pixels = new Uint8Array(width * height * 4)
  return async () => {
    stage.render()
    gl.bindFramebuffer(gl.FRAMEBUFFER, null)
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels)
    if (gl.isContextLost()) throw new Error('the graphics context was lost')
    return topDown(pixels, width, height)
  }
}

/**
 * Reads tiles from a render target that WebGPURenderer uses as its output. The renderer applies tone mapping to this
 * target. A canvas is not used, because presenting a canvas can lose the device.
 */
function targetTile(stage: Stage, width: number, height: number): DrawTile {
  const renderer = stage.renderer as WebGPURenderer
  const target = renderer.getOutputRenderTarget() ?? new RenderTarget(width, height, { depthBuffer: false })
  target.setSize(width, height)
  renderer.setOutputRenderTarget(target)
  return async () => {
    stage.render()
    const pixels = (await renderer.readRenderTargetPixelsAsync(target, 0, 0, width, height)) as Uint8Array
    return stage.backend === 'WebGPU' ? pixels : topDown(pixels, width, height)
  }
}

function topDown(pixels: Uint8Array, width: number, height: number): Uint8Array {
  const rows = new Uint8Array(pixels.length)
  const stride = width * 4
  for (let y = 0; y < height; y++) {
    rows.set(pixels.subarray((height - 1 - y) * stride, (height - y) * stride), y * stride)
  }
  return rows
}
