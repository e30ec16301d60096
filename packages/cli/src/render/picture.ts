/** Messages between Node and the page. Plain data without imports. */

/** Camera views, as in `stage/views.ts`; `left` shows the person's own left side. */
export const VIEW_NAMES = ['front', 'left', 'right', 'three-quarter', 'close'] as const
export const RENDERER_NAMES = ['webgl', 'webgpu'] as const
export const MODE_NAMES = ['default', 'paper', 'composed', 'off'] as const
export const RELIEF_NAMES = ['off', 'on', 'near'] as const

/** Limits of image width and height, pixels. */
export const PICTURE_SIDE = { min: 16, max: 8192 } as const

/** Custom camera view: degrees from the view direction of the face, and zoom; at zoom 1, the face fills the image. */
export interface CameraView {
  yaw: number
  pitch: number
  zoom: number
}

/** Image to draw. */
export interface PictureRequest {
  /** Path of the face: `.glb`, `.gltf` or `.vrm`. */
  input: string
  /** Whether the face and the wrinkle set may reference files outside their folders, default false. */
  allowOutside?: boolean | undefined
  /** Path of a wrinkle set, default the set in the face, otherwise `NAME/wrinkles.json` beside `NAME.glb`. */
  wrinkles?: string
  /** Name of the mesh with wrinkles, default `skin`, otherwise the mesh with most vertices. */
  mesh?: string
  /** Name of an expression of the library, default none: weights as in the file. */
  expression?: string
  /** Blendshape weights by name, 0..1. Override the expression. */
  targets?: Record<string, number>
  /** Activations by area, 0..1. Override the expression. */
  activations?: Record<string, number>
  /** Pixels. */
  width?: number
  /** Pixels. */
  height?: number
  view?: (typeof VIEW_NAMES)[number] | CameraView
  renderer?: (typeof RENDERER_NAMES)[number]
  mode?: (typeof MODE_NAMES)[number]
  /** Whether heights displace the surface; `near`: only where a millimetre is larger than a pixel. */
  relief?: (typeof RELIEF_NAMES)[number]
}

export const PICTURE_DEFAULTS = {
  width: 800,
  height: 600,
  view: 'front',
  renderer: 'webgl',
  mode: 'default',
  relief: 'near',
} as const satisfies Partial<PictureRequest>

/** Request to the page, with defaults applied and files as URLs. */
export interface PageJob
  extends Required<Omit<PictureRequest, 'input' | 'allowOutside' | 'mesh' | 'expression' | 'wrinkles'>> {
  face: string
  /** URL of the wrinkle set; absent if the face contains it, or has none. */
  wrinkles?: string
  mesh?: string
  expression?: string
  /** URL to which the page posts the pixels: RGBA, row 0 at the top. */
  uploadTo: string
}

/** Report of the page about a posted image. */
export interface PageReport {
  /** Graphics API. */
  renderer: 'WebGL 2' | 'WebGPU'
  /** GPU or software rasteriser, as named by its driver. */
  adapter: string
  /** Warnings from the library and three.js. */
  warnings: string[]
}

declare global {
  interface Window {
    /** Defined by the page and called by Node. All calls on a page have the same face, mesh, wrinkle set and renderer. */
    drawPicture(job: PageJob): Promise<PageReport | { error: string }>
  }
}
