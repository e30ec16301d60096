import type { GrayImage } from 'furrow'
import { useLayoutEffect, useRef } from 'preact/hooks'
import type { Mesh } from 'three'
import { runInTurn } from '../../later.ts'
import { colouredArea } from '../../texture/area-colours.ts'
import { palePicture } from '../../texture/pale-picture.ts'
import { cropOf, shrink } from '../../texture/thumbnail.ts'
import type { PanelModel } from '../model.ts'

/** Width and height of a thumbnail, device pixels, for screens with 2 device pixels per CSS pixel. */
const SIDE = 56

/** Thumbnail of an area on the skin's texture. Thumbnails are drawn one at a time, because a face has dozens of areas. */
export function AreaThumbnail({ name, model }: { name: string; model: PanelModel }) {
  const canvas = useRef<HTMLCanvasElement>(null)
  const avatar = model.viewer.value?.avatar
  const weights = model.session.document.value?.areas.find((area) => area.name === name)?.weights
  const meshes = avatar?.skins[avatar.skin].meshes
  useLayoutEffect(() => {
    if (!weights || !meshes) return
    return runInTurn(() => drawThumbnail(canvas.current!, weights, meshes))
  }, [weights, meshes])
  return <canvas ref={canvas} class="thumbnail" width={SIDE} height={SIDE} />
}

function drawThumbnail(
  canvas: HTMLCanvasElement,
  weights: GrayImage,
  meshes: readonly [Mesh, ...Mesh[]],
): void {
  const crop = cropOf(weights)
  const [skin, area] = [palePicture(meshes), document.createElement('canvas')]
  area.width = area.height = SIDE
  area.getContext('2d')!.putImageData(colouredArea(shrink(weights, crop, SIDE)), 0, 0)
  const [x, y, side] = [crop.x, crop.y, crop.side].map((value) => value * skin.width)
  const context = canvas.getContext('2d')!
  context.drawImage(skin, x, y, side, side, 0, 0, SIDE, SIDE)
  context.drawImage(area, 0, 0)
}
