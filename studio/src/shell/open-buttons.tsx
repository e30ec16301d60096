import { FILE } from '../labels/project.ts'
import { FileButton } from '../panels/controls/file-button.tsx'
import type { PanelModel } from '../panels/model.ts'

const FACES = '.glb,.gltf,.vrm,.bin,.png,.jpg,.jpeg,.webp,.ktx2,.json,.zip,.csv'

/** Buttons that open files and folders. */
export function OpenButtons({ model: { actions } }: { model: PanelModel }) {
  return (
    <div class="work">
      <FileButton accept={FACES} isMultiple onChoose={actions.openFiles}>
        {FILE.open}
      </FileButton>
      <FileButton isFolder onChoose={actions.openFiles}>
        {FILE.openFolder}
      </FileButton>
    </div>
  )
}
