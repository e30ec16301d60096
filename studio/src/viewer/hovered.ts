/** Target of the pointer or the focus: an area, the slider of a blendshape, or a blendshape that the face shows. */
export interface Hovered {
  kind: 'area' | 'target' | 'shape'
  name: string
}
