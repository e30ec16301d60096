/** What a picture is made of, in words that both Node and the page understand: plain data, no imports. */

/** Where the camera stands, as `stage/views.ts` has it; `left` shows the person's own left side. */
export const VIEW_NAMES = ['front', 'left', 'right', 'three-quarter', 'close'] as const
export const RENDERER_NAMES = ['webgl', 'webgpu'] as const
export const MODE_NAMES = ['default', 'paper', 'composed', 'off'] as const

/** Shortest and longest side of a picture in pixels. */
export const PICTURE_SIDE = { min: 16, max: 8192 } as const

/** One picture to make. */
export interface PictureRequest {
  /** The face, a `.glb` file. */
  input: string
  /** Its wrinkle set; unless told the one that the face carries, else `<stem>/wrinkles.json` beside it. */
  wrinkles?: string
  /** Name of the mesh that wrinkles; `skin` unless told, and the one with most vertices if none has it. */
  mesh?: string
  /** Name of one of the library's expressions; the face as its file has it unless told. */
  expression?: string
  /** Blendshape weights 0..1, on top of the expression. */
  targets?: Record<string, number>
  /** Activations 0..1 by area, on top of the expression. */
  activations?: Record<string, number>
  /** In pixels. */
  width?: number
  height?: number
  view?: (typeof VIEW_NAMES)[number]
  renderer?: (typeof RENDERER_NAMES)[number]
  mode?: (typeof MODE_NAMES)[number]
}

export const PICTURE_DEFAULTS = {
  width: 800,
  height: 600,
  view: 'front',
  renderer: 'webgl',
  mode: 'default',
} as const satisfies Partial<PictureRequest>

/** What the page is asked to draw: the request with every default filled in and files as addresses. */
export interface PageJob
  extends Required<Omit<PictureRequest, 'input' | 'mesh' | 'expression' | 'wrinkles'>> {
  face: string
  /** Absent where the face carries its own. */
  wrinkles?: string
  mesh?: string
  expression?: string
  /** Where the page posts the pixels: RGBA, row 0 at the top. */
  deliver: string
}

/** What the page says about the picture it has delivered. */
export interface PageReport {
  /** What drew. */
  renderer: 'WebGL 2' | 'WebGPU'
  /** The GPU or software rasteriser, as its driver names it. */
  adapter: string
  /** What library and three.js warned of. */
  warnings: string[]
}

declare global {
  interface Window {
    /** Set by the page; Node calls it, again and again for pictures of one face, mesh, wrinkle set and renderer. */
    drawPicture(job: PageJob): Promise<PageReport | { error: string }>
  }
}
