/** Messages between Node and the page that draws images. This module is for both, so it imports nothing. */

/** Names of camera views, equal to those in `stage/views.ts`. `left` shows the left side of the character. */
export const VIEW_NAMES = ['front', 'left', 'right', 'three-quarter', 'close'] as const
export const RENDERER_NAMES = ['webgl', 'webgpu'] as const
export const MODE_NAMES = ['default', 'paper', 'composed', 'off'] as const
export const RELIEF_NAMES = ['off', 'on', 'near'] as const

export const PICTURE_SIDE = { min: 16, max: 8192 } as const

/**
 * Custom camera view. `yaw` is the angle of the camera from the front towards the person's left side, `pitch` the angle
 * above the horizon, both in degrees. At `zoom` 1, the head fills the image.
 */
export interface CameraView {
  yaw: number
  pitch: number
  zoom: number
}

/** View of one spot of the face. The fields are those of `CloseUp` in `stage/views.ts`. */
export interface CloseUpView {
  yaw: number
  pitch: number
  point: readonly [x: number, y: number, z: number]
  height: number
  light: number
}

/** Rotation of a joint from its rest pose, in the joint's own frame: a unit quaternion. */
export type JointRotation = readonly [x: number, y: number, z: number, w: number]

export interface PictureRequest {
  /** Path of the face: `.glb`, `.gltf` or `.vrm`. */
  input: string
  /** Whether the face and the wrinkle set may reference files outside their folders. Default false. */
  allowOutside?: boolean | undefined
  /** Path of a wrinkle set. Default: the set in the face, otherwise `NAME/wrinkles.json` beside `NAME.glb`. */
  wrinkles?: string
  /** Name of the mesh with wrinkles. Default: `skin`. If there is none: the mesh with most vertices. */
  mesh?: string
  /**
   * Name of an expression of the library. An expression of the wrinkle set with the same name takes precedence. Default:
   * no expression, only the blendshape weights that the file sets.
   */
  expression?: string
  /** Blendshape weights by name, 0..1. They override the expression. */
  targets?: Record<string, number>
  /** Rotations of joints by name. */
  joints?: Record<string, JointRotation>
  /** Activations by area, 0..1. They override the expression. */
  activations?: Record<string, number>
  /** Pixels. */
  width?: number
  /** Pixels. */
  height?: number
  view?: (typeof VIEW_NAMES)[number] | CameraView | CloseUpView
  renderer?: (typeof RENDERER_NAMES)[number]
  mode?: (typeof MODE_NAMES)[number]
  /** Whether heights displace the surface. `near`: only if a millimetre of skin covers more than a pixel. */
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

/** Request to the page. Defaults are applied, and files are URLs. */
export interface PageJob
  extends Required<Omit<PictureRequest, 'input' | 'allowOutside' | 'mesh' | 'expression' | 'wrinkles'>> {
  face: string
  /** URL of the wrinkle set. Absent if the face contains it, or has none. */
  wrinkles?: string
  mesh?: string
  expression?: string
  /** URL to which the page posts the pixels: RGBA bytes, row 0 at the top. */
  uploadTo: string
}

/** Answer of the page after it has posted the pixels of an image. */
export interface PageReport {
  /** Graphics API that drew the image. */
  renderer: 'WebGL 2' | 'WebGPU'
  /** Name of the GPU or software rasteriser, as its driver reports it. */
  adapter: string
  /** Warnings of the library and three.js. */
  warnings: string[]
}

declare global {
  interface Window {
    /**
     * Defined by the page and called by Node. Face, mesh, wrinkle set and renderer must be the same in all calls on one
     * page.
     */
    drawPicture(job: PageJob): Promise<PageReport | { error: string }>
  }
}
