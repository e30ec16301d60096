/** Control under the pointer or with the focus: an area, the slider of a blendshape (`target`), or a recognised blendshape (`shape`). */
export interface Hovered {
  kind: 'area' | 'target' | 'shape'
  name: string
  /** Whether the pointer is on the skin of the face, not on a control. */
  isOnFace?: boolean
}
