interface PosePictureProps {
  /** Picture of the face, or undefined until it is drawn. */
  url: string | undefined
}

/** Picture of an expression on its button, which has the name. */
export function PosePicture({ url }: PosePictureProps) {
  return url === undefined ? <span class="blank" /> : <img src={url} alt="" />
}
