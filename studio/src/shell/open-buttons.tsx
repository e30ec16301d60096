import { FILE } from '../labels.ts'
import type { PanelModel } from '../panels/model.ts'

const FACES = '.glb,.gltf,.vrm,.bin,.png,.jpg,.jpeg,.webp,.ktx2,.json,.zip,.csv'

/** Makes a file input choose folders, by an attribute that JSX lacks. */
function chooseFolder(input: HTMLInputElement | null): void {
  if (input) input.webkitdirectory = true
}

/** Buttons that open files and folders. */
export function OpenButtons({ model: { actions } }: { model: PanelModel }) {
  const open = ({ currentTarget }: { currentTarget: HTMLInputElement }) => {
    actions.openFiles([...currentTarget.files!])
    currentTarget.value = ''
  }
  return (
    <div class="work">
      <label class="file">
        <input type="file" accept={FACES} multiple onChange={open} />
        <span>{FILE.open}</span>
      </label>
      <label class="file">
        <input type="file" ref={chooseFolder} onChange={open} />
        <span>{FILE.openFolder}</span>
      </label>
    </div>
  )
}
