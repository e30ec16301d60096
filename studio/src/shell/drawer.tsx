import { Areas } from '../panels/areas/areas.tsx'
import type { PanelModel } from '../panels/model.ts'
import { MeshList } from './mesh-list.tsx'

/** Drawer at the left: the meshes of the avatar and the regions of the face. */
export function Drawer({ model }: { model: PanelModel }) {
  if (!model.viewer.value) return null
  return (
    <>
      <MeshList model={model} />
      <Areas model={model} />
    </>
  )
}
