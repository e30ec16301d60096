/** What Node and the page tell each other about a picture: plain data, no imports. */

/** Camera views, as in `stage/views.ts`; `left` shows the person's own left side. */
export const VIEW_NAMES = ['front', 'left', 'right', 'three-quarter', 'close'] as const
export const RENDERER_NAMES = ['webgl', 'webgpu'] as const
export const MODE_NAMES = ['default', 'paper', 'composed', 'off'] as const
export const RELIEF_NAMES = ['off', 'on', 'near'] as const

/** Limits of the sides of a picture in pixels. */
export const PICTURE_SIDE = { min: 16, max: 8192 } as const

/** A camera view that has no name: degrees from where the face looks, and magnification; 1 shows the whole face. */
export interface CameraView {
  yaw: number
  pitch: number
  zoom: number
}

/** One picture to draw. */
export interface PictureRequest {
  /** The face: a `.glb`, `.gltf` or `.vrm` file. */
  input: string
  /** Whether the face and the wrinkle set may refer to files outside their folders; they may not by default. */
  allowOutside?: boolean | undefined
  /** Path of a wrinkle set; by default the face's own, otherwise `NAME/wrinkles.json` beside `NAME.glb`. */
  wrinkles?: string
  /** Name of the mesh with wrinkles; by default `skin`, otherwise the mesh with most vertices. */
  mesh?: string
  /** Name of one of the library's expressions; by default the blendshapes are as in the file. */
  expression?: string
  /** Blendshape weights 0..1, on top of the expression. */
  targets?: Record<string, number>
  /** Activations 0..1 by area, on top of the expression. */
  activations?: Record<string, number>
  /** In pixels. */
  width?: number
  height?: number
  view?: (typeof VIEW_NAMES)[number] | CameraView
  renderer?: (typeof RENDERER_NAMES)[number]
  mode?: (typeof MODE_NAMES)[number]
  /** Whether heights move the surface; `auto`: where a millimetre is more than a pixel. */
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

/** What the page is to draw: the request with all defaults applied and files as addresses. */
export interface PageJob
  extends Required<Omit<PictureRequest, 'input' | 'allowOutside' | 'mesh' | 'expression' | 'wrinkles'>> {
  face: string
  /** Absent where the face has its own, or none. */
  wrinkles?: string
  mesh?: string
  expression?: string
  /** Address to which the page posts the pixels: RGBA, row 0 at the top. */
  uploadTo: string
}

/** What the page reports about the picture that it has posted. */
export interface PageReport {
  /** The graphics API. */
  renderer: 'WebGL 2' | 'WebGPU'
  /** The GPU or software rasteriser, as named by its driver. */
  adapter: string
  /** Warnings of the library and three.js. */
  warnings: string[]
}

declare global {
  interface Window {
    /** Defined by the page and called by Node, once per picture of one face, mesh, wrinkle set and renderer. */
    drawPicture(job: PageJob): Promise<PageReport | { error: string }>
  }
}
